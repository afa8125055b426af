// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/base/ids.h"
#include "render/look.h"
#include "ui/document/background_job.h"

#include <array>
#include <optional>

class QGridLayout;
class QLabel;
class QToolButton;

namespace trixel::ui {

class Document;
class Inspection;
class ValueSurvey;
class ViewSettings;

/// What each mark looks like, how many values deserve it in each channel shown, and a way from one
/// such texel to the next.
class MarkTable : public QWidget
{
    Q_OBJECT

public:
    MarkTable(const Document& document,
              const ViewSettings& settings,
              const ValueSurvey& survey,
              Inspection& inspection,
              QWidget* parent = nullptr);

    /// Writes the counts anew.
    void showCounts();
    /// Holds the next texel with a value that deserves the mark, in the order of faces and texels,
    /// from the one that is held on.
    void goToNext(render::Mark mark);
    /// What the last search came to; empty while one runs.
    QString message() const;
    bool isSearching() const { return m_job != nullptr; }

private:
    struct Row
    {
        render::Mark mark{};
        QLabel* swatch = nullptr;
        QLabel* name = nullptr;
        QLabel* counts = nullptr;
        QToolButton* next = nullptr;
    };

    void addRow(QGridLayout& grid, int row, render::Mark mark);
    QString countsOf(render::Mark mark, std::uint64_t& sum, bool& isKnown) const;
    void hold(FaceId face, TexelIndex index);

    const Document& m_document;
    const ViewSettings& m_settings;
    const ValueSurvey& m_survey;
    Inspection& m_inspection;
    BackgroundJobs m_jobs;
    BackgroundJob* m_job = nullptr; ///< that searches now
    std::array<Row, 4> m_rows;
    QLabel* m_message;
};

} // namespace trixel::ui
