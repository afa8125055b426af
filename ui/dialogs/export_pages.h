// SPDX-License-Identifier: GPL-3.0-or-later
//
// What can be chosen of each kind of export: one page of the dialog each.
#pragma once

#include <QStringList>
#include <QWidget>

#include "core/io/export_project.h"

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace trixel::ui {

class TypeChoice;

class ExportPage : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// As the list of kinds shows it.
    virtual QString title() const = 0;
    /// Of the files that it writes, with their dots; the first is what is proposed.
    virtual QStringList endings() const = 0;
    /// \param ending  of the file, one of `endings` (checked)
    virtual ExportOptions options(const QString& ending) const = 0;
    /// Which of its endings is chosen: what means nothing for it cannot be set.
    virtual void setEnding(const QString& /*ending*/) {}
    /// Shows options of this kind; others are passed over.
    virtual void setOptions(const ExportOptions& options) = 0;
    /// The name as the options want it.
    virtual QString named(const QString& path) const { return path; }
    /// The other way round: the name was typed, and options follow it.
    virtual void followName(const QString& /*path*/) {}

signals:
    void changed();
};

class PtxPage : public ExportPage
{
    Q_OBJECT

public:
    /// \param type  that of the texels
    explicit PtxPage(TexelType type, QWidget* parent = nullptr);

    QString title() const override { return tr("Ptex texture (.ptx)"); }
    QStringList endings() const override { return {".ptx"}; }
    ExportOptions options(const QString& ending) const override;
    void setOptions(const ExportOptions& options) override;

private:
    TypeChoice* m_type;
    QCheckBox* m_mips;
};

class PackedPage : public ExportPage
{
    Q_OBJECT

public:
    explicit PackedPage(QWidget* parent = nullptr);

    QString title() const override { return tr("Packed atlas, for shaders"); }
    QStringList endings() const override { return {".exr", ".tif", ".png"}; }
    ExportOptions options(const QString& ending) const override;
    void setOptions(const ExportOptions& options) override;

private:
    QComboBox* m_packing;
    QCheckBox* m_border;
    QCheckBox* m_mips;
    QComboBox* m_page;
};

class MeshPage : public ExportPage
{
    Q_OBJECT

public:
    explicit MeshPage(QWidget* parent = nullptr);

    QString title() const override { return tr("Mesh with uvs, for other programs"); }
    QStringList endings() const override { return {".glb", ".obj", ".ply"}; }
    void setEnding(const QString& ending) override;
    ExportOptions options(const QString& ending) const override;
    void setOptions(const ExportOptions& options) override;

private:
    QSpinBox* m_samples;
    QSpinBox* m_padding;
    QComboBox* m_page;
    QCheckBox* m_powerOfTwo;
    QComboBox* m_image;
};

} // namespace trixel::ui
