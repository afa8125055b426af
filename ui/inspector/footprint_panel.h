// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include "ui/inspector/footprint_answers.h"
#include "ui/inspector/footprint_probe.h"
#include "ui/inspector/footprint_rows.h"
#include "ui/inspector/footprint_sweep.h"

#include <memory>
#include <optional>
#include <vector>

class QCheckBox;
class QSplitter;
class QTabWidget;

namespace trixel::ui {

class Document;
class FilterSceneSource;
class FootprintChoices;
class FootprintNetView;
class FootprintTable;
class FootprintVectors;
class Inspection;
class SweepBar;
class ViewSettings;
class Viewport;

/// What the panel works on; all of it outlives the panel.
struct FootprintWork
{
    Document& document;
    Inspection& inspection;
    ViewSettings& settings;
    FilterSceneSource& filterScene;
    Viewport& viewport;
};

/// The footprint of the inspected texel: laid flat with the weights of its texels, in numbers, on
/// the surface, beside a frozen one, and swept from face-on to grazing. Does nothing while hidden.
class FootprintPanel : public QWidget
{
    Q_OBJECT

public:
    explicit FootprintPanel(const FootprintWork& work, QWidget* parent = nullptr);
    ~FootprintPanel() override;

    FootprintProbe& probe() { return *m_probe; }
    FootprintNetView& netView() { return *m_view; }
    FootprintTable& table() { return *m_table; }
    SweepBar& sweepBar() { return *m_sweepBar; }
    bool isFrozen() const { return m_probe->frozen().has_value(); }
    /// Keeps the footprint as it is to compare it with others, or lets it go.
    void setFrozen(bool frozen);
    /// Whether texels are coloured by weight on the surface, too.
    void setWeightsOnSurface(bool shown);

signals:
    void frozenChanged(bool frozen);
    void weightsOnSurfaceChanged(bool shown);
    void sourceChanged(trixel::ui::FootprintSource source);
    void playingChanged(bool plays);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void makePages();
    QWidget* makeNumbers();
    QWidget* makeVectors();
    void join();
    void setActive(bool active);
    void takeSurface();
    void refresh();
    void refreshFrozen();
    void showNet();
    void takeAnswer();
    void showNumbers();
    void showFrozenNumbers();
    void showOnSurface();
    void sweepLater();
    void startSweep();
    std::optional<FootprintFacts> facts(const std::optional<ProbedFootprint>& probed,
                                        const FootprintAnswers& answers,
                                        const FootprintNet& net) const;
    FootprintNet netOf(const PlacedFootprint& footprint) const;

    FootprintWork m_work;
    QPointer<Viewport> m_viewport;
    /// What signals are led through; ends before anything else does.
    std::unique_ptr<QObject> m_links = std::make_unique<QObject>();
    FootprintProbe* m_probe;
    FootprintAnswers* m_answers;
    FootprintAnswers* m_frozenAnswers;
    FootprintSweep* m_sweep;
    FootprintNet m_net;
    FootprintNet m_frozenNet;
    QTimer m_refresh;    ///< several changes make one
    QTimer m_sweepPause; ///< the pointer moves on before a sweep is worth it

    FootprintChoices* m_choices;
    QSplitter* m_splitter;
    QTabWidget* m_pages;
    QCheckBox* m_onSurface = nullptr;
    QCheckBox* m_enlarge = nullptr;
    FootprintVectors* m_vectors = nullptr;
    FootprintNetView* m_view;
    FootprintTable* m_table;
    SweepBar* m_sweepBar;
};

} // namespace trixel::ui
