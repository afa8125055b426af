// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "core/resample/transfer_paint.h"
#include "ui/document/background_job.h"
#include "ui/exchange/other_file.h"

#include <cstddef>
#include <memory>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace trixel::ui {

class FileField;

/// What the dialog is about: a snapshot, what is selected in it, and what it is erased to.
struct TransferTarget
{
    Project project;
    std::vector<FaceId> selection;
    std::vector<std::byte> fill; ///< the bytes of one texel
};

/// Asks which painted mesh paint is to come from and how far it may come, and says beforehand how
/// many texels it will reach.
class TransferDialog : public QDialog
{
    Q_OBJECT

public:
    /// \param path  proposed file; may be empty
    TransferDialog(TransferTarget target, const QString& path, QWidget* parent = nullptr);

signals:
    void transferWanted(const std::shared_ptr<const trixel::Project>& from,
                        const QString& path,
                        const trixel::TransferOptions& options);

private:
    /// How far texels are from the painted surface, as a sample tells.
    struct Reach
    {
        std::vector<float> distances; ///< ascending
        double secondsPerTexel = 0;   ///< to find the nearest point
        std::uint64_t texels = 0;     ///< of the faces that take paint
    };

    void makeForm(QFormLayout& form);
    void forget();
    void look(const QString& path);
    void take(const Result<std::shared_ptr<const Project>>& from, const QString& path);
    void measure();
    void showReach();
    TransferOptions options() const;
    void finish();

    TransferTarget m_target;
    FileField* m_file;
    QDoubleSpinBox* m_distance;
    QComboBox* m_beyond;
    QCheckBox* m_selected;
    QLabel* m_result;
    QPushButton* m_transfer;
    std::shared_ptr<const Project> m_from; ///< null until it is read
    std::shared_ptr<const Reach> m_reach;  ///< null until it is measured
    quint64 m_generation = 0;
    BackgroundJobs m_jobs; // last: waits for work before the rest dies
};

} // namespace trixel::ui
