// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/filetransaction.h"

#include <cerrno>
#include <cstring>

namespace mb {

FileTransaction::FileTransaction(std::string path)
    : m_path(std::move(path))
    , m_temporary(m_path + ".part")
{
}

FileTransaction::~FileTransaction()
{
    m_file.reset();
    if (m_made)
        std::remove(m_temporary.c_str());
}

tl::unexpected<Error> FileTransaction::failure(int error) const
{
    return fail(Fault::LinkLost, m_path + " cannot be written: " + std::strerror(error));
}

Result<void> FileTransaction::open()
{
    m_file.reset(std::fopen(m_temporary.c_str(), "wbe"));
    if (!m_file)
        return failure(errno);
    m_made = true;
    return {};
}

void FileTransaction::write(std::string_view text)
{
    if (std::fwrite(text.data(), 1, text.size(), m_file.get()) != text.size() && m_error == 0)
        m_error = errno;
}

Result<void> FileTransaction::commit()
{
    if (m_file && std::fclose(m_file.release()) != 0 && m_error == 0)
        m_error = errno;
    if (m_error != 0)
        return failure(m_error);
    if (std::rename(m_temporary.c_str(), m_path.c_str()) != 0)
        return failure(errno);
    m_made = false;
    return {};
}

} // namespace mb
