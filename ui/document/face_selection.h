// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/base/ids.h"
#include "core/mesh/adjacency.h"

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
    std::span<const FaceId> faces() const { return m_faces; }
    bool isEmpty() const { return m_faces.empty(); }
    bool contains(FaceId face) const;

    /// Takes the place of the selection. Any order; faces that do not exist are left out.
    void set(std::vector<FaceId> faces);
    /// A face that does not exist is ignored.
    void add(FaceId face);
    void remove(FaceId face);
    void clear() { set({}); }

    void selectAll();
    void invert();
    /// Adds the faces across the edges of those selected.
    void grow();

signals:
    void changed();

private:
    std::size_t faceCount() const;
    void replace(std::vector<FaceId> sorted);

    Document& m_document;
    std::vector<FaceId> m_faces;
};

} // namespace trixel::ui
