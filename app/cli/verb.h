// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"

#include <functional>

namespace CLI {
class App;
}

namespace trixel::app {

/// How work ended that could be done; becomes exit status 0 or 1.
enum class Outcome { Done, FaultsFound };

/// What a verb does once its arguments are read. Errors become exit status 2 or 3.
using Work = std::function<Result<Outcome>(Progress&)>;

/// Makes a verb known to the parser. When the command line names it, `chosen` becomes its work.
using AddVerb = void (*)(CLI::App& parser, Work& chosen);

void addNew(CLI::App& parser, Work& chosen);
void addInfo(CLI::App& parser, Work& chosen);
void addCheck(CLI::App& parser, Work& chosen);
void addLayers(CLI::App& parser, Work& chosen);
void addPaint(CLI::App& parser, Work& chosen);
void addExport(CLI::App& parser, Work& chosen);
void addConvert(CLI::App& parser, Work& chosen);
void addDiff(CLI::App& parser, Work& chosen);
void addSample(CLI::App& parser, Work& chosen);
void addStudy(CLI::App& parser, Work& chosen);
void addFit(CLI::App& parser, Work& chosen);
void addBake(CLI::App& parser, Work& chosen);
void addBakeOut(CLI::App& parser, Work& chosen);
void addTransfer(CLI::App& parser, Work& chosen);
void addMatch(CLI::App& parser, Work& chosen);

} // namespace trixel::app
