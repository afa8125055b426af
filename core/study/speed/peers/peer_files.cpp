// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/peers/peer_files.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <system_error>

namespace trixel {

TemporaryFolder::TemporaryFolder(std::filesystem::path path)
    : m_path(std::move(path))
{
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored; // nothing can be done about it here
    std::filesystem::remove_all(m_path, ignored);
}

Result<std::shared_ptr<const TemporaryFolder>> TemporaryFolder::make()
{
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "trixel-XXXXXX").string();
    if (error || mkdtemp(name.data()) == nullptr) {
        return pathError("A temporary folder cannot be made: " +
                         (error ? error.message() : std::strerror(errno)) + ".");
    }
    return std::shared_ptr<const TemporaryFolder>(new TemporaryFolder(name));
}

Result<void*> moduleSymbol(const std::filesystem::path& module, const char* symbol)
{
    const auto why = [] {
        const char* text = dlerror();
        return std::string(text != nullptr ? text : "no such symbol");
    };
    void* handle = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (handle == nullptr) {
        return pathError(why());
    }
    void* address = dlsym(handle, symbol);
    return address != nullptr ? Result<void*>(address) : pathError(why());
}

} // namespace trixel
