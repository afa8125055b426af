// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/export_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/dialogs/export_estimate.h"
#include "ui/dialogs/format_choice.h"
#include "ui/dialogs/path_row.h"

namespace trixel::ui {

namespace {

constexpr int kWidth = 520;

/// The name with ".ptx" behind it if it has no ending of that kind.
QString withEnding(const QString& path)
{
    return path.endsWith(".ptx", Qt::CaseInsensitive) ? path : path + ".ptx";
}

} // namespace

ExportDialog::ExportDialog(Project project, const QString& path, QWidget* parent)
    : QDialog(parent)
    , m_project(std::move(project))
    , m_path(new PathRow(PathRow::Purpose::Save, tr("Destination"), tr("Ptex textures (*.ptx)")))
    , m_type(new TypeChoice)
    , m_mips(new QCheckBox(tr("Store &reduced levels (mips)")))
    , m_size(new QLabel)
    , m_note(new QLabel)
{
    setWindowTitle(tr("Export Ptex Texture"));
    setMinimumWidth(kWidth);
    auto* layout = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    layout->addLayout(form);
    form->addRow(tr("&Destination"), m_path);
    form->addRow(tr("&Type"), m_type);
    form->addRow(QString(), m_mips);
    form->addRow(tr("Size"), m_size);
    layout->addWidget(m_note);
    layout->addStretch(1);

    m_mips->setChecked(true);
    m_mips->setToolTip(tr("Renderers read reduced levels for far views; a third more texels"));
    m_mips->setAccessibleName(tr("Store reduced levels"));
    m_size->setAccessibleName(tr("Size estimate"));
    m_size->setToolTip(tr("Estimated by compressing a sample of the faces"));
    m_note->setWordWrap(true);
    m_note->setToolTip(tr("What is to be known before exporting"));
    m_note->setAccessibleName(tr("Note"));

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("&Export"), QDialogButtonBox::AcceptRole);
    m_export->setToolTip(
        tr("Write the file; it is read again and compared before it takes its name"));
    m_export->setAccessibleName(tr("Export"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Write nothing"));
    layout->addWidget(buttons);

    connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_type, &QComboBox::currentIndexChanged, this, &ExportDialog::estimate);
    connect(m_mips, &QCheckBox::toggled, this, &ExportDialog::estimate);
    connect(m_path, &PathRow::pathChanged, this, &ExportDialog::checkPath);
    m_type->setType(m_project.texels.format().type);
    m_path->setPath(path);
    estimate();
    checkPath();
}

void ExportDialog::estimate()
{
    const quint64 generation = ++m_generation;
    m_size->setText(tr("Estimating…"));
    m_jobs.run(
        tr("Estimating…"),
        [texels = m_project.texels, type = m_type->type(), mips = m_mips->isChecked()](
            Progress& /*progress*/) -> Result<ExportEstimate> {
            return estimatePtx(texels, type, mips);
        },
        [this, generation](const Result<ExportEstimate>& estimate) {
            if (generation != m_generation || !estimate) {
                return;
            }
            m_size->setText(
                tr("about %1, mesh included (texels before compression: %2)")
                    .arg(sizeText(estimate->likelyBytes), sizeText(estimate->plainBytes)));
        });
}

void ExportDialog::checkPath()
{
    const QString path = m_path->path();
    const QFileInfo file(withEnding(path));
    QString note;
    bool usable = !path.isEmpty();
    if (usable && file.isDir()) {
        note = tr("%1 is a folder: a file name is wanted.").arg(file.fileName());
        usable = false;
    } else if (usable && !file.absoluteDir().exists()) {
        note = tr("The folder %1 does not exist.").arg(file.absolutePath());
        usable = false;
    } else if (usable && !QFileInfo(file.absolutePath()).isWritable()) {
        note = tr("The folder %1 cannot be written to.").arg(file.absolutePath());
        usable = false;
    } else if (usable && file.exists()) {
        note = tr("%1 exists and will be replaced.").arg(file.fileName());
    }
    m_note->setText(note);
    m_export->setEnabled(usable);
}

void ExportDialog::finish()
{
    emit exportWanted(QFileInfo(withEnding(m_path->path())).absoluteFilePath(),
                      m_type->type(),
                      m_mips->isChecked());
    accept();
}

} // namespace trixel::ui
