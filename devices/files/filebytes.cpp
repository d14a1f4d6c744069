// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/filebytes.h"

#include "async/outputfile.h"
#include "files/qttext.h"
#include "files/textfile.h"

#include <QFile>

namespace mb {

Result<void> saveFile(const std::string &path, const QByteArray &bytes)
{
    return writeFile(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

Result<QByteArray> loadFile(const std::string &path, std::int64_t limit)
{
    if (path.starts_with(":/")) { // a resource of the program, which only Qt can read
        QFile resource(qt(path));
        if (!resource.open(QIODevice::ReadOnly))
            return fail(Fault::OutOfRange, say("%1 is not in this program", path));
        return resource.readAll();
    }
    MB_TRY(auto text, readTextFile(path, static_cast<std::size_t>(limit)));
    return QByteArray::fromStdString(text);
}

} // namespace mb
