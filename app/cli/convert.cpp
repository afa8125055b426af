// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/file_kind.h"
#include "app/cli/verb.h"
#include "core/io/ptx_convert.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string input;
    std::string output;
    std::optional<std::string> type;
    bool noMips = false;
};

Result<Outcome> convert(const Arguments& arguments, Progress& progress)
{
    for (const std::string& name : {arguments.input, arguments.output}) {
        if (const Status ending = expectEnding(name, FileKind::Ptx); !ending) {
            return tl::unexpected(ending.error());
        }
    }
    PtxConvertOptions options;
    options.mips = !arguments.noMips;
    if (arguments.type) {
        const auto type = texelType("--type", *arguments.type);
        if (!type) {
            return tl::unexpected(type.error());
        }
        options.type = *type;
    }
    return convertPtx(arguments.input, arguments.output, options, progress).map([] {
        return Outcome::Done;
    });
}

} // namespace

void addConvert(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand("convert", "Rewrite a .ptx");
    verb->add_option("IN", arguments->input, "File to read (.ptx)")->required()->type_name("FILE");
    verb->add_option("OUT", arguments->output, "File to write (.ptx)")
        ->required()
        ->type_name("FILE");
    verb->add_option("--type", arguments->type, "uint8, uint16, half or float; else as it is")
        ->type_name("TYPE");
    verb->add_flag("--no-mips", arguments->noMips, "Store full resolution only");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return convert(*arguments, progress); };
    });
}

} // namespace trixel::app
