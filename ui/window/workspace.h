// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMainWindow;

namespace trixel::ui {

class BackgroundJobs;
class BrushColors;
class Document;
class FaceSelection;
class FilterSceneSource;
class Inspection;
class MessageBar;
class ViewMap;
class ViewSettings;
class Viewport;

/// What the panels of one window work on together; all of it outlives them.
struct Workspace
{
    QMainWindow& window;
    Document& document;
    FaceSelection& selection;
    Inspection& inspection;
    ViewSettings& settings;
    BrushColors& colors;
    BackgroundJobs& jobs;
    FilterSceneSource& filterScene;
    Viewport& viewport;
    ViewMap& viewMap;
    MessageBar& messages;
};

} // namespace trixel::ui
