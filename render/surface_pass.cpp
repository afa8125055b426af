// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface_pass.h"

#include <QVector2D>
#include <QVector3D>

#include "core/base/check.h"
#include "core/filter/probe_plan.h"
#include "render/color_map.h"
#include "render/matrices.h"

#include <algorithm>
#include <string>
#include <utility>

namespace trixel::render {

namespace {

/// As the shader's LOOK.
constexpr std::size_t kAsTheyAre = 0;
constexpr std::size_t kRanged = 1;
constexpr std::size_t kNumber = 2;
constexpr std::size_t kFalseColor = 3;
constexpr std::size_t kFaceColors = 4;
constexpr std::size_t kLookShift = 6; // of it in a variant

/// Pixels that the longest edge may be wide for levels to be found a vertex: between the corners of
/// smaller faces they change as they would from pixel to pixel.
constexpr double kSmallFace = 8;

constexpr int kProbes = 16; // of a pixel that is filtered anisotropically, at most

std::size_t lookOf(const LookRule& rule)
{
    switch (rule.kind) {
    case LookRule::Kind::Colors:
        return rule.black == 0 && rule.scale == 1 ? kAsTheyAre : kRanged;
    case LookRule::Kind::Grey:
        return kNumber;
    case LookRule::Kind::FalseColor:
        break;
    }
    return kFalseColor;
}

std::size_t variantOf(const SurfaceStyle& style, const LookRule& rule, bool isPainted = false)
{
    const bool isOfTexels = !style.faceColors;
    const std::size_t look = isOfTexels ? lookOf(rule) : kFaceColors;
    // Light would turn the colours of the scale into others.
    const bool isLit = style.lit && look != kFalseColor;
    const bool hasAlpha = style.hasAlpha && look < kNumber && rule.opacity >= 0;
    const bool hasMarks = rule.marks && isOfTexels;
    return (isLit ? 1U : 0U) | (style.wireframe ? 2U : 0U) | (style.texelGrid ? 4U : 0U) |
           (hasAlpha ? 8U : 0U) | (hasMarks ? 16U : 0U) | (isPainted && isOfTexels ? 32U : 0U) |
           (look << kLookShift);
}

/// Variants of one way of filtering.
constexpr std::size_t kLooks = 320;

std::size_t filteringOf(const SurfaceStyle& style)
{
    return style.faceColors ? 0 : static_cast<std::size_t>(style.filtering);
}

/// Whether some style and look ask for it; of ways of filtering but the first, those with both
/// kinds of lines or none stand for all.
bool occurs(std::size_t variant)
{
    const std::size_t look = variant % kLooks >> kLookShift;
    const bool hasLines = (variant & 2U) != 0;
    const bool hasGrid = (variant & 4U) != 0;
    return (look < kNumber || (variant & 8U) == 0) &&
           (look != kFalseColor || (variant & 1U) == 0) &&
           (look < kFaceColors || (variant & 48U) == 0) &&
           (variant < kLooks || (look < kFaceColors && hasLines == hasGrid));
}

QString levelsPiece()
{
    return QStringLiteral("filter_levels.glsl");
}

QStringList piecesOf(std::size_t variant)
{
    switch (static_cast<Filtering>(variant / kLooks)) {
    case Filtering::PackedAtlas:
        return {QStringLiteral("filter_atlas.glsl")};
    case Filtering::Seamless:
        return {levelsPiece(),
                QStringLiteral("filter_vertices.glsl"),
                QStringLiteral("filter_seamless.glsl")};
    case Filtering::Anisotropic:
        return {levelsPiece(),
                QStringLiteral("filter_vertices.glsl"),
                QStringLiteral("filter_texels.glsl"),
                QStringLiteral("filter_anisotropic.glsl")};
    case Filtering::Texels:
    case Filtering::LowerHalf:
        break;
    }
    return {};
}

QByteArray definesOf(std::size_t variant, bool isLimit, bool hasVertexLevels)
{
    QByteArray lines;
    std::size_t bit = 1;
    for (const char* name : {"LIT", "WIREFRAME", "TEXEL_GRID", "ALPHA", "MARKS", "PAINTED"}) {
        lines += QByteArray("#define ") + name + ((variant & bit) != 0 ? " 1\n" : " 0\n");
        bit *= 2;
    }
    const auto number = [](std::size_t n) { return QByteArray::number(static_cast<int>(n)); };
    return lines + "#define LOOK " + number(variant % kLooks >> kLookShift) +
           "\n#define FILTERING " + number(variant / kLooks) + "\n#define LIMIT " +
           number(isLimit ? 1 : 0) + "\n#define VERTEX_LEVELS " + number(hasVertexLevels ? 1 : 0) +
           "\n";
}

std::vector<Rgba> scaleColors()
{
    std::vector<Rgba> colors(kMapColors);
    for (std::size_t k = 0; k < colors.size(); ++k) {
        const Rgb color = mapColor(static_cast<double>(k) / static_cast<double>(kMapColors - 1));
        colors[k] = {color[0], color[1], color[2], 255};
    }
    return colors;
}

QVector3D vectorOf(const Rgba& color)
{
    return QVector3D(color[0], color[1], color[2]) / 255.0F;
}

} // namespace

Result<std::unique_ptr<SurfacePass>> SurfacePass::create(Gl& gl)
{
    std::unique_ptr<SurfacePass> pass(new SurfacePass(gl));
    if (const Status made = pass->makeProgram(variantOf(SurfaceStyle(), LookRule()), Drawn::Faces);
        !made) {
        return tl::unexpected(made.error());
    }
    return pass;
}

SurfacePass::SurfacePass(Gl& gl)
    : m_gl(gl)
    , m_limit(gl)
    , m_corners(gl)
    , m_positions(gl, GL_RGB32F, sizeof(glm::vec3))
    , m_triangles(gl, GL_RGB32UI, sizeof(Triangle))
    , m_faceColors(gl, GL_RGBA8, sizeof(std::uint32_t))
    , m_scale(gl, GL_RGBA8, sizeof(Rgba))
    , m_scales(gl, GL_RGBA32UI, sizeof(VertexScale))
    , m_across(gl, GL_R32UI, sizeof(std::uint32_t))
{
    const std::vector<Rgba> colors = scaleColors();
    m_scale.fill(std::as_bytes(std::span(colors)));
}

Status SurfacePass::makeProgram(std::size_t variant, Drawn drawn)
{
    const bool isLimit = drawn == Drawn::Limit;
    const QByteArray defines = definesOf(variant, isLimit, drawn == Drawn::SmallFaces);
    const QStringList ofVertex =
        drawn == Drawn::SmallFaces ? QStringList(levelsPiece()) : QStringList();
    auto made = loadProgram(isLimit ? QStringLiteral("limit.vert") : QStringLiteral("surface.vert"),
                            QStringLiteral("surface.frag"),
                            defines,
                            piecesOf(variant),
                            defines,
                            ofVertex);
    if (!made) {
        return tl::unexpected(made.error());
    }
    QOpenGLShaderProgram& program = **made;
    program.bind();
    program.setUniformValue("positions", 0);
    program.setUniformValue("triangles", 1);
    program.setUniformValue("records", 3);
    program.setUniformValue("texels", 4);
    program.setUniformValue("faceColors", 5);
    program.setUniformValue("scaleColors", 6);
    program.setUniformValue("scales", 9);
    program.setUniformValue("across", 10);
    program.setUniformValue("atlas", 11);
    program.setUniformValue("texelRecords", 12);
    program.setUniformValue("faceTexels", 13);
    const std::array<QVector3D, 5> marks{QVector3D(),
                                         vectorOf(markColor(Mark::Clipped)),
                                         vectorOf(markColor(Mark::Negative)),
                                         vectorOf(markColor(Mark::Infinite)),
                                         vectorOf(markColor(Mark::NotANumber))};
    program.setUniformValueArray("markColors", marks.data(), static_cast<int>(marks.size()));
    program.release();
    m_programs[static_cast<std::size_t>(drawn)][variant] = std::move(*made);
    return {};
}

Status SurfacePass::makeAllPrograms()
{
    for (std::size_t variant = 0; variant < kVariants; ++variant) {
        if (!occurs(variant)) {
            continue;
        }
        if (const Status made = makeProgram(variant, Drawn::Faces); !made) {
            return made;
        }
        if (static_cast<Filtering>(variant / kLooks) == Filtering::Seamless) {
            if (const Status made = makeProgram(variant, Drawn::SmallFaces); !made) {
                return made;
            }
        }
        // Of the limit surface few stand for all: they have the fragments in common.
        if (const bool isOne = variant % kLooks % 8 == 0; isOne) {
            if (const Status made = makeProgram(variant, Drawn::Limit); !made) {
                return made;
            }
        }
    }
    return {};
}

Status SurfacePass::setMesh(const TriangleMesh& mesh)
{
    m_faceCount = 0;
    setFilterMesh(nullptr);
    m_limit.set(nullptr);
    m_corners.set({});
    m_faceColors.fill({});
    const std::size_t most = TextureBuffer::maxElements(m_gl);
    if (mesh.positions.size() > most || 3 * mesh.faceCount() > most) {
        return contentsError("The graphics card shows at most " + std::to_string(most / 3) +
                             " faces; the mesh has " + std::to_string(mesh.faceCount()) + ".");
    }
    m_positions.fill(std::as_bytes(std::span(mesh.positions)));
    m_triangles.fill(std::as_bytes(std::span(mesh.triangles)));
    m_faceCount = mesh.faceCount();
    m_vertexCount = mesh.positions.size();
    return {};
}

void SurfacePass::setCorners(const SharedCorners& corners)
{
    check(corners.faces.empty() || corners.faces.size() == m_faceCount, "corners of the mesh");
    m_corners.set(corners);
}

void SurfacePass::setFaceColors(std::span<const std::uint32_t> colors)
{
    m_colorsPerFace = colors.size() == 3 * m_faceCount ? 3 : 1;
    check(colors.empty() ||
              colors.size() == static_cast<std::size_t>(m_colorsPerFace) * m_faceCount,
          "a colour a face, or one a corner");
    m_faceColors.fill(std::as_bytes(colors));
}

void SurfacePass::setFilterMesh(std::shared_ptr<const FilterMesh> mesh)
{
    check(!mesh || (mesh->faceCount() == m_faceCount && mesh->scales().size() == m_vertexCount),
          "of the mesh that is drawn");
    m_filterMesh = std::move(mesh);
    m_across.fill({});
    m_scales.fill(m_filterMesh ? std::as_bytes(std::span(m_filterMesh->scales()))
                               : std::span<const std::byte>());
}

/// What the shader needs to know for ways of filtering over vertices.
void SurfacePass::setFilter(QOpenGLShaderProgram& program,
                            const Camera& camera,
                            const SurfaceStyle& style)
{
    const Filtering filtering = style.filtering;
    const glm::mat4 projection = camera.projection();
    const glm::ivec2 size = camera.viewport();
    if (filtering == Filtering::Anisotropic && m_across.size() == 0) {
        m_across.fill(std::as_bytes(std::span(m_filterMesh->across())));
    }
    m_scales.bind(9);
    program.setUniformValue("unitsPerPixel", 2 / (projection[0][0] * static_cast<float>(size.x)));
    program.setUniformValue("levelCut", style.levelCut);
    program.setUniformValue("levelsDropped", static_cast<float>(style.levelsDropped));
    if (filtering != Filtering::Anisotropic) {
        return;
    }
    m_across.bind(10);
    const ProbeSettings settings = probeSettings(kProbes, 1);
    program.setUniformValue("toClip", toQt(projection * camera.view()));
    program.setUniformValue(
        "halfViewport", QVector2D(static_cast<float>(size.x) / 2, static_cast<float>(size.y) / 2));
    program.setUniformValue("probeSpacing", static_cast<float>(settings.spacing));
    program.setUniformValue("probeFalloff", static_cast<float>(settings.falloff));
    program.setUniformValue("probeSupport", static_cast<float>(settings.support));
    program.setUniformValue("probeThinnest", static_cast<float>(probeCap(settings).thinnest));
    program.setUniformValue("probesAside", kProbes / 2);
}

SurfacePass::Drawn SurfacePass::drawnOf(const Camera& camera, const SurfaceStyle& style) const
{
    if (style.limit && m_limit.shown()) {
        return Drawn::Limit;
    }
    if (style.filtering != Filtering::Seamless || style.faceColors || style.pixelLevels ||
        !m_filterMesh) {
        return Drawn::Faces;
    }
    const double pixels = m_filterMesh->longestEdge() / camera.nearestWorldPerPixel();
    return pixels <= kSmallFace ? Drawn::SmallFaces : Drawn::Faces;
}

void SurfacePass::setLook(QOpenGLShaderProgram& program, const CardLook& look)
{
    const LookRule& rule = look.rule;
    program.setUniformValue("black", rule.black);
    program.setUniformValue("scale", rule.scale);
    program.setUniformValue("most", rule.most);
    program.setUniformValue("component", rule.number == LookRule::kLuminance ? -1 : look.component);
}

void SurfacePass::draw(const Camera& camera,
                       const SurfaceStyle& style,
                       SurfaceTexels& texels,
                       const CardLook& look,
                       PaintPreview* preview,
                       SurfaceAtlas* atlas,
                       SurfaceTexels* own)
{
    if (m_faceCount == 0 || (atlas == nullptr ? texels.isEmpty() : atlas->isEmpty())) {
        return;
    }
    // The same source has compiled for another style: failing here is for lack of memory at most.
    SurfaceStyle possible = style;
    possible.faceColors = style.faceColors && m_faceColors.size() > 0;
    const bool isPainted = preview != nullptr && preview->isShown();
    const std::size_t variant =
        variantOf(possible, look.rule, isPainted) + kLooks * filteringOf(possible);
    const Drawn drawn = drawnOf(camera, possible);
    const bool isLimit = drawn == Drawn::Limit;
    Program& made = m_programs[static_cast<std::size_t>(drawn)][variant];
    if (!made && !makeProgram(variant, drawn)) {
        return;
    }
    QOpenGLShaderProgram& program = *made;
    program.bind();
    if (filteringOf(possible) >= static_cast<std::size_t>(Filtering::Seamless)) {
        check(m_filterMesh != nullptr, "a mesh to filter over");
        setFilter(program, camera, possible);
    }
    m_positions.bind(0);
    m_triangles.bind(1);
    if (atlas != nullptr) {
        atlas->bind(3, 11);
    } else {
        texels.bind(3, 4);
    }
    if (possible.filtering == Filtering::Anisotropic && own != nullptr && !own->isEmpty()) {
        own->bind(12, 13);
    }
    m_faceColors.bind(5);
    program.setUniformValue("colorsPerFace", m_colorsPerFace);
    m_scale.bind(6);
    setLook(program, look);
    if (isPainted) {
        preview->use(program, look.channels, 7, 8);
    }
    program.setUniformValue("view", toQt(camera.view()));
    program.setUniformValue("projection", toQt(camera.projection()));
    program.setUniformValue("hasNormals", isLimit || m_corners.areShared());
    program.setUniformValue("areShared", m_corners.areShared());
    program.setUniformValue("lineWidth", style.pixelRatio);

    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDepthFunc(GL_LESS);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glDisable(GL_BLEND);
    if (isLimit) {
        m_limit.draw();
    } else {
        m_corners.draw(m_faceCount);
    }
    program.release();
}

} // namespace trixel::render
