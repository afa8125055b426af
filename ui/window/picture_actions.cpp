// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/picture_actions.h"

#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>

#include "core/lattice/texel.h"
#include "ui/charts/write_chart.h"
#include "ui/document/background_job.h"
#include "ui/document/document.h"
#include "ui/document/inspection.h"
#include "ui/inspector/picture_file.h"
#include "ui/inspector/save_dialog.h"
#include "ui/inspector/view_picture.h"
#include "ui/inspector/widget_picture.h"
#include "ui/look/look_words.h"
#include "ui/viewport/method_title.h"
#include "ui/viewport/view_settings.h"
#include "ui/viewport/viewport.h"
#include "ui/window/actions.h"
#include "ui/window/message_bar.h"

#include <utility>

namespace trixel::ui {

namespace {

constexpr auto kCaptionKey = "picture/caption";

/// How a picture is saved, in the order that the dialog offers it.
enum Kind { AsSharpAsTheScreen, OnePixel, TwoPixels, Drawing };

QList<SaveKind> kindsFor(const PictureSource& source)
{
    QList<SaveKind> kinds{
        {PictureActions::tr("Picture, as sharp as the screen (*.png)"), "png"},
        {PictureActions::tr("Picture, a pixel for each unit (*.png)"), "png"},
        {PictureActions::tr("Picture, twice as sharp (*.png)"), "png"},
    };
    if (source.isVectorPicture()) {
        kinds += {PictureActions::tr("Drawing of lines and areas (*.svg)"), "svg"};
    }
    return kinds;
}

QString texelText(const InspectedTexel& texel)
{
    return PictureActions::tr("face %1, texel %2 of level %3")
        .arg(indexOf(texel.place.face))
        .arg(indexOf(texelIndex(texel.level, texel.place.texel)))
        .arg(texel.level.log2());
}

} // namespace

PictureActions::PictureActions(const Workspace& work)
    : QObject(&work.window)
    , m_work(work)
{
    const Maker view = [this] { return std::make_unique<ViewPicture>(m_work.viewport); };
    m_saveView = addSave(tr("Save &Picture…"),
                         tr("Save a picture of the view, legends included"),
                         view,
                         QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S));
    m_copyView = addCopy(tr("Copy P&icture"),
                         tr("Put a picture of the view on the clipboard"),
                         view,
                         QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_C));
    m_captions =
        ActionMaker(m_work.window)
            .toggle(tr("&Captions"), tr("Write file, texel, look and filter below pictures"));
    m_captions->setChecked(QSettings().value(kCaptionKey, true).toBool());
    connect(m_captions, &QAction::toggled, this, [](bool on) {
        QSettings().setValue(kCaptionKey, on);
    });
    for (QDockWidget* dock : m_work.window.findChildren<QDockWidget*>()) {
        addPanel(*dock);
    }
}

void PictureActions::fillMenu(QMenu& menu)
{
    menu.addAction(m_saveView);
    menu.addAction(m_copyView);
    QMenu* panels = menu.addMenu(tr("Pictures of Pane&ls"));
    for (QAction* action : m_panelActions) {
        panels->addAction(action);
    }
    panels->addSeparator();
    panels->addAction(m_captions);
}

QString PictureActions::caption() const
{
    if (!m_captions->isChecked() || !m_work.document.isOpen()) {
        return {};
    }
    QStringList parts{m_work.document.title()};
    if (const auto& texel = m_work.inspection.texel()) {
        parts += texelText(*texel);
    }
    const QString look = describe(m_work.document.texels().format(), m_work.settings.look());
    if (!look.isEmpty()) {
        parts += look;
    }
    parts += tr("filter %1").arg(methodTitle(m_work.settings.method()));
    return parts.join(" · ");
}

/// In the menu and by a right click on the panel where nothing else answers it.
void PictureActions::addPanel(QDockWidget& dock)
{
    const Maker panel = [&dock] { return pictureOf(*dock.widget(), dock.windowTitle()); };
    const QString text = tr("Save Picture of %1…").arg(dock.windowTitle());
    QAction* listed = addSave(withMnemonic(text, m_mnemonics, text.indexOf(dock.windowTitle())),
                              tr("Save a picture of the panel %1").arg(dock.windowTitle()),
                              panel);
    // A hidden panel shows nothing that is true now.
    listed->setEnabled(dock.isVisible());
    connect(&dock, &QDockWidget::visibilityChanged, listed, &QAction::setEnabled);
    m_panelActions.push_back(listed);
    auto* here = new QAction(tr("&Save Picture…"), &dock);
    here->setToolTip(listed->toolTip());
    connect(here, &QAction::triggered, this, [this, panel] { save(panel); });
    auto* copied = new QAction(tr("&Copy Picture"), &dock);
    copied->setToolTip(
        tr("Put a picture of the panel %1 on the clipboard").arg(dock.windowTitle()));
    connect(copied, &QAction::triggered, this, [this, panel] { copy(panel); });
    dock.addActions({here, copied});
    dock.setContextMenuPolicy(Qt::ActionsContextMenu);
}

QAction* PictureActions::addSave(const QString& text,
                                 const QString& toolTip,
                                 const Maker& maker,
                                 const QKeySequence& shortcut)
{
    QAction* action = ActionMaker(m_work.window)(text, toolTip, shortcut);
    connect(action, &QAction::triggered, this, [this, maker] { save(maker); });
    return action;
}

QAction* PictureActions::addCopy(const QString& text,
                                 const QString& toolTip,
                                 const Maker& maker,
                                 const QKeySequence& shortcut)
{
    QAction* action = ActionMaker(m_work.window)(text, toolTip, shortcut);
    connect(action, &QAction::triggered, this, [this, maker] { copy(maker); });
    return action;
}

/// What is saved is what the panel shows when the file has been chosen.
void PictureActions::save(const Maker& maker)
{
    const std::unique_ptr<PictureSource> source = maker();
    if (source->pictureSize().isEmpty()) {
        m_work.messages.showError(tr("There is nothing to make a picture of."));
        return;
    }
    const QString title = m_work.document.isOpen() ? m_work.document.title() : tr("Trixel");
    askWhereToSave(m_work.window,
                   tr("Save the Picture"),
                   title + ' ' + source->pictureName().toLower(),
                   kindsFor(*source),
                   [this, maker](const QString& path, int kind) { write(*maker(), path, kind); });
}

void PictureActions::copy(const Maker& maker)
{
    const Result<QImage> image = imageOf(*maker(), caption(), density());
    if (!image) {
        m_work.messages.showError(QString::fromStdString(image.error().message));
        return;
    }
    QGuiApplication::clipboard()->setImage(*image);
    m_work.messages.showNote(tr("The picture is on the clipboard."));
}

void PictureActions::write(PictureSource& source, const QString& path, int kind)
{
    if (kind == Drawing) {
        const Result<QByteArray> svg = svgOf(source, caption());
        if (!svg) {
            m_work.messages.showError(QString::fromStdString(svg.error().message));
            return;
        }
        writeInBackground(path, [bytes = *svg](const std::filesystem::path& file) {
            return writeText(file, std::string_view(bytes.constData(), std::size_t(bytes.size())));
        });
        return;
    }
    const double pixels = kind == OnePixel ? 1 : kind == TwoPixels ? 2 : density();
    const Result<QImage> image = imageOf(source, caption(), pixels);
    if (!image) {
        m_work.messages.showError(QString::fromStdString(image.error().message));
        return;
    }
    writeInBackground(path, [picture = *image](const std::filesystem::path& file) {
        return writePng(picture, file);
    });
}

void PictureActions::writeInBackground(const QString& path,
                                       std::function<Status(const std::filesystem::path&)> work)
{
    m_work.jobs.run(
        tr("Saving the picture…"),
        [file = std::filesystem::path(path.toStdString()),
         work = std::move(work)](Progress& /*progress*/) { return work(file); },
        [this, path](const Status& status) {
            if (status) {
                m_work.messages.showNote(tr("The picture was written to %1.").arg(path));
            } else {
                m_work.messages.showError(QString::fromStdString(status.error().message));
            }
        });
}

double PictureActions::density() const
{
    return m_work.window.devicePixelRatioF();
}

} // namespace trixel::ui
