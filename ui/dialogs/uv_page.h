// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/export_pages.h"

namespace trixel::ui {

/// Images by the mesh's own uvs: one, or one for each tile.
class UvPage : public ExportPage
{
    Q_OBJECT

public:
    explicit UvPage(QWidget* parent = nullptr);

    QString title() const override { return tr("Image by the mesh's own uvs"); }
    QStringList endings() const override { return {".png", ".tif", ".exr", ".tx"}; }
    void setEnding(const QString& ending) override;
    ExportOptions options(const QString& ending) const override;
    void setOptions(const ExportOptions& options) override;
    QString named(const QString& path) const override;
    void followName(const QString& path) override;

private:
    QComboBox* m_size;
    QSpinBox* m_gutter;
    QCheckBox* m_tiles;
    QCheckBox* m_levels;
    QComboBox* m_type;
    QComboBox* m_space;
};

} // namespace trixel::ui
