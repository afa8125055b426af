// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/base/ids.h"
#include "core/mesh/adjacency.h"

#include <memory>
#include <span>
#include <vector>

namespace trixel::ui {

class Document;

/// The faces that the user has chosen; none once another project opens. Not part of undo.
class FaceSelection : public QObject
{
    Q_OBJECT

public:
    explicit FaceSelection(Document& document, QObject* parent = nullptr);

    /// Ascending, each once.
    std::span<const FaceId> faces() const { return *m_faces; }
    /// The same, to be kept while the selection changes.
    std::shared_ptr<const std::vector<FaceId>> snapshot() const { return m_faces; }
    bool isEmpty() const { return m_faces->empty(); }
    bool contains(FaceId face) const;

    /// Takes the place of the selection. Any order; faces that do not exist are left out.
    void set(std::vector<FaceId> faces);
    /// Any order; faces that do not exist are ignored.
    void add(std::vector<FaceId> more);
    void remove(std::vector<FaceId> others);
    void clear() { set({}); }

    void selectAll();
    void invert();
    /// Adds the faces across the edges of those selected.
    void grow();

signals:
    void changed();

private:
    std::size_t faceCount() const;
    std::vector<FaceId> usable(std::vector<FaceId> faces) const;
    void replace(std::vector<FaceId> sorted);

    Document& m_document;
    std::shared_ptr<const std::vector<FaceId>> m_faces =
        std::make_shared<const std::vector<FaceId>>();
};

} // namespace trixel::ui
