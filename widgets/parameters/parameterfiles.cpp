// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterfiles.h"

#include "files/filebytes.h"
#include "model/registry.h"
#include "widgets/common/devicetext.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonDocument>

namespace mb {
namespace {

constexpr std::int64_t largestParameterFile = 4'000'000;

struct FileText {
    Q_DECLARE_TR_FUNCTIONS(FileText)
};

tl::unexpected<RefusedFile> refuse(const QString &cause, const QString &remedy)
{
    return tl::unexpected<RefusedFile>(RefusedFile{cause, remedy});
}

QString titleOf(std::string_view family)
{
    const Family *known = findFamily(families(), family);
    return known ? qt(known->title) : FileText::tr("family “%1”").arg(qt(family));
}

} // namespace

FromFile<ParameterFile> loadParameterFile(const QString &path, const Family &family, const QString &owner)
{
    const auto bytes = loadFile(path.toStdString(), largestParameterFile);
    if (!bytes)
        return refuse(errorText(bytes.error()), FileText::tr("Choose another file."));
    if (const auto other = familyOf(*bytes); other && *other != family.key)
        return refuse(FileText::tr("%1 is for %2, %3 is of the family %4.")
                          .arg(fileNameOf(path), titleOf(*other), owner, qt(family.title)),
            FileText::tr("Choose a file of this family. Nothing was changed."));
    auto file = parseParameterFile(*bytes, family);
    if (!file)
        return refuse(
            fileNameOf(path) + QStringLiteral(": ") + errorText(file.error()), FileText::tr("Nothing was changed."));
    return std::move(*file);
}

FromFile<const Family *> loadFamily(const QString &path)
{
    const auto bytes = loadFile(path.toStdString(), largestParameterFile);
    if (!bytes)
        return refuse(errorText(bytes.error()), FileText::tr("Choose another file."));
    const auto key = familyOf(*bytes);
    if (!key)
        return refuse(FileText::tr("%1 is not a parameter file.").arg(fileNameOf(path)),
            FileText::tr("Choose a file that Export… or motorbenchctl get --file wrote."));
    const Family *family = findFamily(families(), *key);
    if (!family)
        return refuse(FileText::tr("%1 is for %2, which is not in this program.").arg(fileNameOf(path), titleOf(*key)),
            FileText::tr("Choose another file."));
    return family;
}

std::vector<ParameterStore::Entry> entriesOf(const Family &family, const ParameterFile &file)
{
    std::vector<ParameterStore::Entry> entries(family.parameters.size());
    for (const ParameterChange &change : file.values) {
        const bool persistent = family.parameters[change.index.value].persistent;
        entries[change.index.value] = {change.raw, persistent ? ParameterState::Stored : ParameterState::Volatile};
    }
    return entries;
}

QByteArray parameterFileText(const ParameterSource &source)
{
    std::vector<ParameterIndex> indices;
    for (std::uint16_t i = 0; i < source.family.parameters.size(); ++i) {
        if (source.family.parameters[i].access != Access::WriteOnly)
            indices.push_back({i});
    }
    return QJsonDocument(parametersToJson(source, indices)).toJson(QJsonDocument::Indented);
}

QString fileNameOf(const QString &path)
{
    return QFileInfo(path).fileName();
}

QString parameterFilters()
{
    return FileText::tr("Parameter files (*.json)") + QStringLiteral(";;") + FileText::tr("All files (*)");
}

} // namespace mb
