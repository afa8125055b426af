// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "ui/dialogs/aligned_forms.h"
#include "ui/dialogs/export_estimate.h"
#include "ui/dialogs/export_pages.h"
#include "ui/dialogs/format_choice.h"
#include "ui/dialogs/path_row.h"
#include "ui/dialogs/uv_page.h"

#include <algorithm>
#include <ranges>
#include <utility>

namespace trixel::ui {

namespace {

constexpr int kWidth = 560;
/// In the list of presets; the others come from `presets`.
constexpr int kCustom = 0;
/// Data of the kinds: their file's ending and the page of their options.
constexpr int kEndingRole = Qt::UserRole;
constexpr int kPageRole = Qt::UserRole + 1;

struct Preset
{
    QString name;
    QString ending;
    ExportOptions options;
};

std::vector<Preset> presets()
{
    HandOffExportOptions engine;
    engine.layout.powerOfTwo = true;
    engine.layout.padding = 4;
    HandOffExportOptions painter;
    PackedExportOptions shader;
    shader.layout.mips = true;
    UvExportOptions texture;
    texture.levels = true;
    return {{ExportDialog::tr("Renderer: .ptx with reduced levels"),
             ".ptx",
             PtxExportOptions{std::nullopt, true}},
            {ExportDialog::tr("Game engine: .glb, sides powers of two"), ".glb", engine},
            {ExportDialog::tr("Another program: .obj and PNG"), ".obj", painter},
            {ExportDialog::tr("Own shader: packed .exr with levels"), ".exr", shader},
            {ExportDialog::tr("Renderer with uvs: .tx with levels"), ".tx", texture},
            {ExportDialog::tr("Archive: .ptx, texels alone"),
             ".ptx",
             PtxExportOptions{std::nullopt, false}}};
}

QString endingOf(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    return ending.isEmpty() ? QString() : "." + (ending == "tiff" ? QString("tif") : ending);
}

/// "R", "G", "B", "A" where those are what they are.
QString channelName(std::uint16_t channel, const TexelFormat& format)
{
    if (format.alpha == channel) {
        return ExportDialog::tr("Channel %1, opacity").arg(channel);
    }
    const QStringList colors = {
        ExportDialog::tr("red"), ExportDialog::tr("green"), ExportDialog::tr("blue")};
    return format.channels >= 3 && channel < 3
               ? ExportDialog::tr("Channel %1, %2").arg(channel).arg(colors[channel])
               : ExportDialog::tr("Channel %1").arg(channel);
}

/// Page of images by uvs, which a mesh may lack.
constexpr int kUvPage = 3;

void disable(QComboBox& choice, int index, const QString& why)
{
    if (auto* items = qobject_cast<QStandardItemModel*>(choice.model())) {
        items->item(index)->setEnabled(false);
        items->item(index)->setToolTip(why);
    }
}

} // namespace

ExportDialog::ExportDialog(ExportSource source, const QString& path, QWidget* parent)
    : QDialog(parent)
    , m_source(std::move(source))
    , m_path(new PathRow(PathRow::Purpose::Save,
                         tr("Destination"),
                         tr("Ptex textures (*.ptx);;Images and packed atlases (*.exr *.tif *.png "
                            "*.tx);;Meshes with uvs (*.glb *.obj *.ply)")))
    , m_preset(new QComboBox)
    , m_kind(new QComboBox)
    , m_pages(new QStackedWidget)
    , m_selected(new QCheckBox)
    , m_layer(new QComboBox)
    , m_channel(new QComboBox)
    , m_size(new QLabel)
    , m_note(new QLabel)
{
    setWindowTitle(tr("Export"));
    setMinimumWidth(kWidth);
    auto* layout = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    layout->addLayout(form);
    form->addRow(tr("&For"), m_preset);
    form->addRow(tr("&Destination"), m_path);
    form->addRow(tr("&Kind"), m_kind);
    form->addRow(m_pages);
    form->addRow(tr("Fa&ces"), m_selected);
    if (!m_source.project.layers.isPlain()) {
        form->addRow(tr("&Layer"), m_layer);
    }
    form->addRow(tr("Cha&nnels"), m_channel);
    form->addRow(tr("Size"), m_size);
    layout->addWidget(m_note);
    layout->addStretch(1);
    addPages();
    addPart();
    addLayers();
    listChannels();
    alignLabels();

    m_size->setAccessibleName(tr("Size estimate"));
    m_size->setToolTip(tr("Pages, bytes and time; compression is tried on a sample of the faces"));
    m_size->setWordWrap(true);
    m_note->setWordWrap(true);
    m_note->setToolTip(tr("What is to be known before exporting"));
    m_note->setAccessibleName(tr("Note"));

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("&Export"), QDialogButtonBox::AcceptRole);
    m_export->setToolTip(
        tr("Write the files; each is read again and compared before it takes its name"));
    m_export->setAccessibleName(tr("Export"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Write nothing"));
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connectAll();
    begin(path);
}

/// One page for each kind of options, in the order of their alternatives.
void ExportDialog::addPages()
{
    const bool hasUvs = m_source.project.surface->mesh().hasUvs();
    for (ExportPage* page :
         {static_cast<ExportPage*>(new PtxPage(m_source.project.texels.format().type)),
          static_cast<ExportPage*>(new PackedPage),
          static_cast<ExportPage*>(new MeshPage),
          static_cast<ExportPage*>(new UvPage)}) {
        const int index = m_pages->addWidget(page);
        const bool isUsable = index != kUvPage || hasUvs;
        for (const QString& ending : page->endings()) {
            QString title = page->endings().size() == 1 ? page->title()
                                                        : tr("%1 (%2)").arg(page->title(), ending);
            if (!isUsable) {
                title += tr(": the mesh has none");
            }
            m_kind->addItem(title);
            const int kind = m_kind->count() - 1;
            m_kind->setItemData(kind, ending, kEndingRole);
            m_kind->setItemData(kind, index, kPageRole);
            if (!isUsable) {
                disable(
                    *m_kind, kind, tr("The mesh came without uvs: an OBJ or PLY may have some"));
            }
        }
        connect(page, &ExportPage::changed, this, &ExportDialog::takeChange);
    }
    m_kind->setAccessibleName(tr("Kind"));
    m_kind->setToolTip(tr("What the project is written as"));
    m_preset->addItem(tr("Custom"));
    for (const Preset& preset : presets()) {
        m_preset->addItem(preset.name);
        if (std::holds_alternative<UvExportOptions>(preset.options) && !hasUvs) {
            disable(*m_preset, m_preset->count() - 1, tr("The mesh came without uvs"));
        }
    }
    m_preset->setAccessibleName(tr("Destination preset"));
    m_preset->setToolTip(tr("Settings that suit who will read it"));
}

void ExportDialog::addPart()
{
    const std::size_t selected = m_source.selection.size();
    m_selected->setText(selected == 0 ? tr("Only selected ones (none is)")
                                      : tr("&Only the %1 selected").arg(countText(selected)));
    m_selected->setEnabled(selected > 0);
    m_selected->setAccessibleName(tr("Only selected faces"));
    m_selected->setToolTip(tr("Leaves other faces out, mesh and texels"));
    m_channel->setAccessibleName(tr("Channels"));
    m_channel->setToolTip(tr("All channels or one alone"));
}

/// In the order in which they lie, the topmost first.
void ExportDialog::addLayers()
{
    m_layer->setParent(this); // where no row holds it
    m_layer->setHidden(m_source.project.layers.isPlain());
    m_layer->addItem(tr("All together, as shown"));
    for (const Layer& one : std::views::reverse(m_source.project.layers.layers())) {
        m_layer->addItem(QString::fromStdString(one.settings.name), static_cast<quint32>(one.id));
    }
    m_layer->addItem(tr("Base"), static_cast<quint32>(kBaseLayer));
    m_layer->setAccessibleName(tr("Layer"));
    m_layer->setToolTip(tr("All layers as they look together, or one alone, shown or not: what it "
                           "covers becomes its opacity, as one channel more"));
}

std::optional<LayerId> ExportDialog::layer() const
{
    const QVariant chosen = m_layer->currentData();
    return chosen.isValid() ? std::optional(LayerId{chosen.toUInt()}) : std::nullopt;
}

void ExportDialog::listChannels()
{
    const QSignalBlocker quiet(m_channel);
    const QVariant before = m_channel->currentData();
    const std::optional<LayerId> alone = layer();
    const TexelFormat& base = m_source.project.texels.format();
    const TexelFormat format = alone && *alone != kBaseLayer ? layerFormat(base) : base;
    m_channel->clear();
    m_channel->addItem(tr("All %1").arg(format.channels), -1);
    for (std::uint16_t k = 0; k < format.channels; ++k) {
        m_channel->addItem(channelName(k, format), k);
    }
    m_channel->setCurrentIndex(std::max(0, m_channel->findData(before)));
}

void ExportDialog::connectAll()
{
    connect(m_preset, &QComboBox::currentIndexChanged, this, &ExportDialog::applyPreset);
    connect(m_kind, &QComboBox::currentIndexChanged, this, [this](int kind) {
        chooseKind(kind);
        becomeCustom();
    });
    connect(m_path, &PathRow::pathChanged, this, &ExportDialog::followPath);
    connect(m_selected, &QCheckBox::toggled, this, &ExportDialog::estimate);
    connect(m_layer, &QComboBox::currentIndexChanged, this, [this] {
        listChannels();
        estimate();
    });
    connect(m_channel, &QComboBox::currentIndexChanged, this, &ExportDialog::estimate);
}

void ExportDialog::begin(const QString& path)
{
    m_isFilling = true;
    m_path->setPath(path);
    if (m_source.latest) {
        const ExportRequest& latest = *m_source.latest;
        for (int k = 0; k < m_pages->count(); ++k) {
            pageAt(k).setOptions(latest.options);
        }
        if (const auto alone = latest.part.layer; alone && m_source.project.layers.has(*alone)) {
            m_layer->setCurrentIndex(m_layer->findData(static_cast<quint32>(*alone)));
        }
    }
    m_isFilling = false;
    if (m_source.latest) { // some endings are those of several pages
        const int kind = kindOn(static_cast<int>(m_source.latest->options.index()), endingOf(path));
        m_kind->setCurrentIndex(kind >= 0 ? kind : m_kind->currentIndex());
    }
    followPath();
    estimate();
}

ExportPage& ExportDialog::pageAt(int index) const
{
    return *static_cast<ExportPage*>(m_pages->widget(index));
}

ExportPage& ExportDialog::page() const
{
    return pageAt(m_pages->currentIndex());
}

int ExportDialog::kindOn(int page, const QString& ending) const
{
    for (int kind = 0; kind < m_kind->count(); ++kind) {
        if (m_kind->itemData(kind, kPageRole) == page &&
            m_kind->itemData(kind, kEndingRole) == ending) {
            return kind;
        }
    }
    return -1;
}

int ExportDialog::kindOf(const QString& ending) const
{
    const int here = kindOn(m_pages->currentIndex(), ending);
    if (here >= 0) {
        return here;
    }
    for (int page = 0; page < m_pages->count(); ++page) {
        const int kind = kindOn(page, ending);
        const bool isUsable = page != kUvPage || m_source.project.surface->mesh().hasUvs();
        if (kind >= 0 && isUsable) {
            return kind;
        }
    }
    return -1;
}

void ExportDialog::alignLabels()
{
    QList<QFormLayout*> forms = findChildren<QFormLayout*>();
    alignForms(forms);
}

/// Another option on the open page: the file's name may follow from it.
void ExportDialog::takeChange()
{
    if (m_isFilling) {
        return;
    }
    if (const QString name = page().named(m_path->path()); name != m_path->path()) {
        m_path->setPath(name);
    }
    becomeCustom();
}

QString ExportDialog::pathWithEnding() const
{
    const QString path = m_path->path();
    const QString ending = m_kind->currentData(kEndingRole).toString();
    return path.isEmpty() || endingOf(path) == ending ? path : path + ending;
}

ExportRequest ExportDialog::request() const
{
    const QString ending = m_kind->currentData(kEndingRole).toString();
    ExportRequest request;
    request.path = QFileInfo(pathWithEnding()).absoluteFilePath().toStdString();
    request.options = page().options(ending);
    if (m_selected->isChecked()) {
        request.part.faces = m_source.selection;
    }
    if (const int channel = m_channel->currentData().toInt(); channel >= 0) {
        request.part.channels = {static_cast<std::uint16_t>(channel)};
    }
    request.part.layer = layer();
    return request;
}

void ExportDialog::applyPreset(int preset)
{
    if (m_isFilling || preset == kCustom) {
        return;
    }
    const Preset chosen = presets()[static_cast<std::size_t>(preset - 1)];
    m_isFilling = true;
    const int kind = kindOn(static_cast<int>(chosen.options.index()), chosen.ending);
    m_kind->setCurrentIndex(kind);
    chooseKind(kind);
    page().setOptions(chosen.options);
    m_isFilling = false;
    estimate();
}

/// A known ending that is typed chooses the kind.
void ExportDialog::followPath()
{
    const int kind = kindOf(endingOf(m_path->path()));
    if (kind >= 0 && kind != m_kind->currentIndex()) {
        m_kind->setCurrentIndex(kind);
    }
    page().followName(m_path->path());
    checkPath();
}

void ExportDialog::chooseKind(int kind)
{
    const QString ending = m_kind->itemData(kind, kEndingRole).toString();
    m_pages->setCurrentIndex(m_kind->itemData(kind, kPageRole).toInt());
    page().setEnding(ending);
    changeEnding(ending);
}

void ExportDialog::changeEnding(const QString& ending)
{
    const QString path = m_path->path();
    const QString now = endingOf(path);
    if (now != ending && kindOf(now) >= 0) {
        m_path->setPath(path.chopped(QFileInfo(path).suffix().size() + 1) + ending);
    }
    checkPath();
}

void ExportDialog::becomeCustom()
{
    if (m_isFilling) {
        return;
    }
    m_isFilling = true;
    m_preset->setCurrentIndex(kCustom);
    m_isFilling = false;
    estimate();
}

void ExportDialog::estimate()
{
    if (m_isFilling) {
        return;
    }
    const quint64 generation = ++m_generation;
    m_size->setText(tr("Estimating…"));
    m_jobs.run(
        tr("Estimating…"),
        [project = m_source.project, wanted = request()](Progress& progress) {
            return estimateExport(project, wanted, progress);
        },
        [this, generation](const Result<QString>& sentence) {
            if (generation != m_generation) {
                return;
            }
            m_isWritable = sentence.has_value();
            m_size->setText(sentence ? *sentence
                                     : QString::fromStdString(sentence.error().message));
            checkPath();
        });
}

void ExportDialog::checkPath()
{
    const QString path = m_path->path();
    const QFileInfo file(pathWithEnding());
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
    } else if (usable && kindOf(endingOf(path)) < 0 && endingOf(path) == ".tx") {
        note = tr("A .tx is an image by the mesh's uvs, and the mesh has none.");
        usable = false;
    } else if (usable && file.exists()) {
        note = tr("%1 exists and will be replaced.").arg(file.fileName());
    }
    m_note->setText(note);
    m_export->setEnabled(usable && m_isWritable);
}

void ExportDialog::finish()
{
    emit exportWanted(request());
    accept();
}

} // namespace trixel::ui
