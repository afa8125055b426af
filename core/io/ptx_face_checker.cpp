// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_face_checker.h"

#include "core/io/ptx_average.h"
#include "core/io/ptx_faces.h"
#include "core/lattice/reduction.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace trixel {

namespace {

// How far a stored value may lie from the exact mean of the four it is made from, when the writer
// rounded to nearest or cut off what is left: less than one step of an integer.
double toleranceOf(TexelType type, double largest)
{
    switch (type) {
    case TexelType::UInt8:
        return 1.0 / 255 * 0.999;
    case TexelType::UInt16:
        return 1.0 / 65535 * 0.999;
    case TexelType::Half: // a step is 2^-10 of the value, or 2^-24 among the smallest
        return std::ldexp(largest, -10) + std::ldexp(1.0, -24);
    case TexelType::Float:
        break;
    }
    return std::ldexp(largest, -21) + 1e-38;
}

} // namespace

bool PtxFaceChecker::read(FaceId face, int reduction, std::vector<float>& values)
{
    const std::string name = "face " + std::to_string(indexOf(face));
    const auto stored = m_file.decode(face, reduction, m_decoder);
    if (!stored) {
        m_faults.add(PtxFault::Block, indexOf(face), stored.error().message);
        return false;
    }
    if (!*stored) {
        m_faults.add(PtxFault::Reduction,
                     indexOf(face),
                     name + " lacks its reduction number " + std::to_string(reduction));
        return false;
    }
    const Level level = m_file.info(face).level().coarser(reduction);
    values.resize(std::size_t{level.texelCount()} * m_file.format().channels);
    decode(m_file.format().type,
           m_decoder.texels.first(level.texelCount() * m_file.format().texelBytes()),
           values);
    return true;
}

void PtxFaceChecker::check(FaceId face)
{
    const PtxFaceInfo& info = m_file.info(face);
    if (info.isConstant() || !read(face, 0, m_finer)) {
        return;
    }
    checkAverage(face);
    if (m_file.levelCount() == 1 || info.isEdited()) {
        return;
    }
    premultiply();
    for (int k = 1; k <= ptxReductions(info.level()); ++k) {
        if (!read(face, k, m_coarser)) {
            return;
        }
        checkReduction(face, k);
        std::swap(m_finer, m_coarser);
    }
}

void PtxFaceChecker::premultiply()
{
    const TexelFormat& format = m_file.format();
    if (!format.alpha) {
        return;
    }
    const auto [first, last] = premultipliedChannels(format);
    for (std::size_t t = 0; t < m_finer.size(); t += format.channels) {
        for (std::size_t c = first; c < last; ++c) {
            m_finer[t + c] *= m_finer[t + *format.alpha];
        }
    }
}

void PtxFaceChecker::checkReduction(FaceId face, int reduction)
{
    const TexelFormat& format = m_file.format();
    const std::size_t channels = format.channels;
    const Level fine = m_file.info(face).level().coarser(reduction - 1);
    const Level coarse = fine.coarser();
    // Premultiplied texels were themselves rounded or cut off before they were averaged.
    const double slack = format.alpha && reduction == 1 ? 2 : 1;
    for (std::size_t t = 0; t < coarse.texelCount(); ++t) {
        const auto from = finerPixels(fine, packedPixel(coarse, static_cast<TexelIndex>(t)));
        for (std::size_t c = 0; c < channels; ++c) {
            double sum = 0;
            double largest = 0;
            for (const PackedPixel pixel : from) {
                const double value = m_finer[indexOf(texelIndex(fine, pixel)) * channels + c];
                sum += value;
                largest = std::max(largest, std::abs(value));
            }
            const double stored = m_coarser[t * channels + c];
            const double difference = std::abs(stored - sum / 4);
            // Neither infinities nor NaN have a mean to compare with.
            if (std::isfinite(sum) && !(difference <= slack * toleranceOf(format.type, largest))) {
                m_faults.add(PtxFault::Reduction,
                             indexOf(face),
                             "face " + std::to_string(indexOf(face)) + ", reduced " +
                                 std::to_string(reduction) + " times, has texel " +
                                 std::to_string(t) + " off the mean of its four by " +
                                 std::to_string(difference));
                return;
            }
        }
    }
}

void PtxFaceChecker::checkAverage(FaceId face)
{
    const TexelFormat& format = m_file.format();
    if (format.alpha) {
        return; // weighted by opacity and divided by it: rounding can be of any size
    }
    const std::size_t channels = format.channels;
    std::vector<float> stored(channels);
    decode(format.type, m_file.constantValue(face), stored);
    for (std::size_t c = 0; c < channels; ++c) {
        double sum = 0;
        double largest = 0;
        for (std::size_t k = c; k < m_finer.size(); k += channels) {
            sum += m_finer[k];
            largest = std::max(largest, double{std::abs(m_finer[k])});
        }
        const double mean = sum / static_cast<double>(m_finer.size() / channels);
        // A writer may take the mean of the smallest reduction, each level of which was cut off.
        const double steps = 2 + m_file.info(face).level().log2();
        const double difference = std::abs(stored[c] - mean);
        if (std::isfinite(mean) && !(difference <= steps * toleranceOf(format.type, largest))) {
            m_faults.add(PtxFault::Average,
                         indexOf(face),
                         "face " + std::to_string(indexOf(face)) +
                             " has an average that is off by " + std::to_string(difference) +
                             " in channel " + std::to_string(c));
            return;
        }
    }
}

} // namespace trixel
