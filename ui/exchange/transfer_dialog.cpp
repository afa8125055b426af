// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/exchange/transfer_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/dialogs/format_choice.h"
#include "ui/exchange/file_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trixel::ui {

namespace {

constexpr int kWidth = 560;
constexpr std::size_t kSamples = 2000;
/// Of the mesh's size: what two meshes of one shape differ by where they are made of other faces.
constexpr double kLikelyDistance = 0.02;
/// Finding the nearest point and averaging the paint there take about as long as each other.
constexpr double kFindAndAverage = 2;

/// Two digits of a length, above 0.
double rounded(double length)
{
    if (!(length > 0) || !std::isfinite(length)) {
        return 1;
    }
    const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1);
    return std::max(1e-6, std::round(length / unit) * unit);
}

QString lengthText(double length)
{
    return QString::number(length, 'g', 3);
}

QString durationText(double seconds)
{
    return seconds < 1    ? TransferDialog::tr("under a second")
           : seconds < 90 ? TransferDialog::tr("about %1 s").arg(std::ceil(seconds))
                          : TransferDialog::tr("about %1 min").arg(std::ceil(seconds / 60));
}

} // namespace

TransferDialog::TransferDialog(TransferTarget target, const QString& path, QWidget* parent)
    : QDialog(parent)
    , m_target(std::move(target))
    , m_file(new FileField(tr("Painted file"),
                           tr("Projects and textures (*.trixel *.ptx);;All files (*)"),
                           tr("A project, or a .ptx that carries its mesh, of any faces.")))
    , m_distance(new QDoubleSpinBox)
    , m_beyond(new QComboBox)
    , m_selected(new QCheckBox)
    , m_result(new QLabel)
{
    setWindowTitle(tr("Transfer Paint"));
    setMinimumWidth(kWidth);
    auto* layout = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    form->setVerticalSpacing(8);
    makeForm(*form);
    layout->addLayout(form);
    layout->addStretch(1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_transfer = buttons->addButton(tr("&Transfer"), QDialogButtonBox::AcceptRole);
    m_transfer->setAccessibleName(tr("Transfer"));
    m_transfer->setToolTip(tr("Bring the paint over in the background; one undo step"));
    m_transfer->setDefault(true);
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Change nothing"));
    buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
    layout->addWidget(buttons);

    connect(buttons, &QDialogButtonBox::accepted, this, &TransferDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_file, &FileField::left, this, &TransferDialog::forget);
    connect(m_file, &FileField::lookWanted, this, &TransferDialog::look);
    connect(m_distance, &QDoubleSpinBox::valueChanged, this, &TransferDialog::showReach);
    connect(m_beyond, &QComboBox::currentIndexChanged, this, &TransferDialog::showReach);
    connect(m_selected, &QCheckBox::toggled, this, &TransferDialog::measure);
    forget();
    m_file->setPath(path);
}

void TransferDialog::makeForm(QFormLayout& form)
{
    const double likely = rounded(kLikelyDistance * double{m_target.project.surface->size()});
    // Two digits more than the proposed length needs.
    m_distance->setDecimals(std::clamp(3 - static_cast<int>(std::floor(std::log10(likely))), 2, 9));
    m_distance->setRange(std::pow(10.0, -m_distance->decimals()), 1e9);
    m_distance->setValue(likely);
    m_distance->setSuffix(tr(" units"));
    m_distance->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    m_distance->setAccessibleName(tr("Distance"));
    m_distance->setToolTip(
        tr("How far a texel looks for the painted surface, in units of the meshes; at first a "
           "fiftieth of this mesh's size"));
    m_beyond->addItem(tr("Keep what they hold"), int(OutOfReach::Keep));
    m_beyond->addItem(tr("Are erased to the fill colour"), int(OutOfReach::Fill));
    m_beyond->setAccessibleName(tr("Texels beyond"));
    m_beyond->setToolTip(tr("What becomes of texels that find no paint within the distance"));
    const std::size_t selected = m_target.selection.size();
    m_selected->setText(selected == 0 ? tr("Only selected ones (none is)")
                                      : tr("&Only the %1 selected").arg(countText(selected)));
    m_selected->setEnabled(selected > 0);
    m_selected->setChecked(selected > 0); // a selection masks everything
    m_selected->setAccessibleName(tr("Only selected faces"));
    m_selected->setToolTip(tr("Other faces keep their texels"));
    m_result->setWordWrap(true);
    m_result->setAlignment(Qt::AlignTop);
    m_result->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_result->setAccessibleName(tr("Reach estimate"));
    m_result->setToolTip(tr("Told from a sample of the texels"));
    form.addRow(tr("&Paint from"), m_file);
    form.addRow(tr("&Within"), m_distance);
    form.addRow(tr("Texels &beyond"), m_beyond);
    form.addRow(tr("Faces"), m_selected);
    form.addRow(tr("Reach"), m_result);
}

void TransferDialog::forget()
{
    ++m_generation;
    if (BackgroundJob* job = m_jobs.latest()) {
        job->cancel();
    }
    m_from.reset();
    m_reach.reset();
    showReach();
}

void TransferDialog::look(const QString& path)
{
    forget();
    m_jobs.run(
        tr("Reading…"),
        [path](Progress& progress) { return openPainted(path, progress); },
        [this, path, generation = m_generation](
            const Result<std::shared_ptr<const Project>>& from) {
            if (generation == m_generation) {
                take(from, path);
            }
        });
}

void TransferDialog::take(const Result<std::shared_ptr<const Project>>& from, const QString& path)
{
    if (!from) {
        m_file->showError(sentenceOf(from.error(), path));
        return;
    }
    m_from = *from;
    const TexelFormat& theirs = m_from->texels.format();
    const TexelFormat& ours = m_target.project.texels.format();
    QString found =
        tr("%1 faces, %2 texels, %3 channels.")
            .arg(countText(m_from->texels.faceCount()), countText(m_from->texels.texelCount()))
            .arg(theirs.channels);
    if (theirs.channels < ours.channels) {
        found += " " + tr("Channels that it lacks stay as they are.");
    } else if (theirs.channels > ours.channels) {
        found += " " + tr("Only the first %1 are taken.").arg(ours.channels);
    }
    m_file->showFound(found);
    measure();
}

/// How far the texels that are to take paint are from it.
void TransferDialog::measure()
{
    m_reach.reset();
    showReach();
    if (!m_from) {
        return;
    }
    const quint64 generation = ++m_generation;
    m_jobs.run(
        tr("Measuring…"),
        [from = m_from, target = m_target.project, faces = options().faces](
            Progress& /*progress*/) -> Result<std::shared_ptr<const Reach>> {
            auto reach = std::make_shared<Reach>();
            QElapsedTimer clock;
            clock.start();
            reach->distances =
                sampleDistances(*from->surface, *target.surface, target.texels, kSamples, faces);
            const auto samples =
                static_cast<double>(std::max<std::size_t>(1, reach->distances.size()));
            reach->secondsPerTexel = static_cast<double>(clock.nsecsElapsed()) * 1e-9 / samples;
            std::ranges::sort(reach->distances);
            for (const FaceId face : faces) {
                reach->texels += target.texels.face(face).level().texelCount();
            }
            if (faces.empty()) {
                reach->texels = target.texels.texelCount();
            }
            return std::shared_ptr<const Reach>(std::move(reach));
        },
        [this, generation](const Result<std::shared_ptr<const Reach>>& reach) {
            if (generation == m_generation && reach) {
                m_reach = *reach;
                showReach();
            }
        });
}

void TransferDialog::showReach()
{
    m_transfer->setEnabled(false);
    if (!m_reach) {
        m_result->setText(m_from ? tr("Measuring…") : QString());
        return;
    }
    const std::vector<float>& distances = m_reach->distances;
    if (distances.empty()) {
        m_result->setText(QString::fromUtf8("⚠ ") + tr("One of the meshes has no faces."));
        return;
    }
    const auto within =
        std::ranges::upper_bound(distances, static_cast<float>(m_distance->value()));
    const auto reached = static_cast<double>(within - distances.begin());
    const double part = reached / static_cast<double>(distances.size());
    if (reached == 0) {
        m_result->setText(QString::fromUtf8("⚠ ") +
                          tr("No texel seems to be so near: the nearest of a sample is %1 units "
                             "away.")
                              .arg(lengthText(double{distances.front()})));
        return;
    }
    const double seconds = kFindAndAverage * m_reach->secondsPerTexel *
                           static_cast<double>(m_reach->texels) / Threads::all().count;
    QString text = tr("About %1 % of %2 texels take paint, %3.")
                       .arg(QString::number(std::min(100 * part, part < 1 ? 99.9 : 100.0),
                                            'f',
                                            part < 1 && part > 0.99 ? 1 : 0),
                            countText(m_reach->texels),
                            durationText(seconds));
    if (part < 1) {
        text += " " + tr("All would within %1 units.").arg(lengthText(double{distances.back()}));
    }
    m_result->setText(text);
    m_transfer->setEnabled(true);
}

TransferOptions TransferDialog::options() const
{
    TransferOptions options;
    options.maxDistance = static_cast<float>(m_distance->value());
    options.outOfReach = static_cast<OutOfReach>(m_beyond->currentData().toInt());
    options.fill = m_target.fill;
    if (m_selected->isChecked()) {
        options.faces = m_target.selection;
    }
    return options;
}

void TransferDialog::finish()
{
    emit transferWanted(m_from, m_file->path(), options());
    accept();
}

} // namespace trixel::ui
