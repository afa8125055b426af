// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/exchange/compare_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/dialogs/format_choice.h"
#include "ui/exchange/file_field.h"

#include <utility>

namespace trixel::ui {

namespace {

constexpr int kWidth = 560;

} // namespace

CompareDialog::CompareDialog(Project project, const QString& path, QWidget* parent)
    : QDialog(parent)
    , m_project(std::move(project))
    , m_file(new FileField(tr("Second file"),
                           tr("Textures and projects (*.ptx *.trixel);;All files (*)"),
                           tr("A .ptx or a project of the same mesh.")))
    , m_matches(new QCheckBox(tr("&Match its faces to this mesh's")))
{
    setWindowTitle(tr("Compare"));
    setMinimumWidth(kWidth);
    auto* layout = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    form->setVerticalSpacing(8);
    form->addRow(tr("Compare &with"), m_file);
    form->addRow(QString(), m_matches);
    layout->addLayout(form);
    layout->addStretch(1);

    m_matches->setAccessibleName(tr("Match its faces to this mesh's"));
    m_matches->setToolTip(
        tr("Its faces are in another order, begun at other corners or wound the other way round: "
           "compare each with its counterpart, or else with the one of the same number"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_compare = buttons->addButton(tr("&Compare"), QDialogButtonBox::AcceptRole);
    m_compare->setAccessibleName(tr("Compare"));
    m_compare->setToolTip(tr("Measure every face in the background"));
    m_compare->setDefault(true);
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Compare nothing"));
    buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &CompareDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_file, &FileField::left, this, &CompareDialog::forget);
    connect(m_file, &FileField::lookWanted, this, &CompareDialog::look);
    forget();
    m_file->setPath(path);
}

void CompareDialog::forget()
{
    ++m_generation;
    if (BackgroundJob* looking = m_jobs.latest()) {
        looking->cancel();
    }
    m_compare->setEnabled(false);
    m_matches->setVisible(false);
}

void CompareDialog::look(const QString& path)
{
    forget();
    m_jobs.run(
        tr("Reading…"),
        [path, surface = m_project.surface, format = m_project.texels.format()](
            Progress& progress) { return lookAtOther(toPath(path), *surface, format, progress); },
        [this, path, generation = m_generation](const Result<OtherFile>& other) {
            if (generation == m_generation) {
                take(other, path);
            }
        });
}

void CompareDialog::take(const Result<OtherFile>& other, const QString& path)
{
    if (!other) {
        m_file->showError(sentenceOf(other.error(), path));
        return;
    }
    QString found =
        tr("%1 faces, %2, %3 channels.")
            .arg(countText(other->faceCount), QString::fromUtf8(nameOf(other->format.type).data()))
            .arg(other->format.channels);
    if (other->needsMatch()) {
        found += " " + tr("It fits %1.").arg(QString::fromStdString(other->match.describe()));
    }
    m_file->showFound(found);
    m_matches->setVisible(other->needsMatch());
    m_matches->setChecked(other->needsMatch());
    m_compare->setEnabled(true);
}

void CompareDialog::finish()
{
    emit compareWanted(m_file->path(), m_matches->isChecked());
    accept();
}

} // namespace trixel::ui
