// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/fileexchange.h"

#include "files/filebytes.h"
#include "widgets/common/banner.h"
#include "widgets/common/devicetext.h"
#include "widgets/parameters/editdesk.h"
#include "widgets/parameters/parameterfiles.h"

namespace mb {
namespace {

// Notices in the strip of the window.
constexpr auto importNotice = "parameters import";
constexpr auto fileNotice = "parameters file";

/// Rows of its file that have a number.
auto knownOf(const DeviceView &device)
{
    std::ptrdiff_t known = 0;
    for (std::size_t i = 0; i < device.parameters->size(); ++i)
        known += device.family->parameters[i].access != Access::WriteOnly && (*device.parameters)[i].raw ? 1 : 0;
    return known;
}

} // namespace

FileExchange::FileExchange(Workbench &workbench, BannerStack &banners, ParameterView &view)
    : QObject(&view)
    , m_workbench(workbench)
    , m_banners(banners)
    , m_view(view)
{
    connect(&banners, &BannerStack::actionTriggered, this, &FileExchange::act);
}

/// The only button of these notices: "Undo the import".
void FileExchange::act(const QString &key)
{
    StagedEdits *edits = EditDesk::of(m_workbench).find(m_importedInto);
    if (key != QLatin1String(importNotice) || !edits)
        return;
    const int last = edits->undoStack().index();
    m_view.commitField(); // which may be an edit after it
    if (edits->undoStack().index() == last)
        edits->undoStack().undo();
}

void FileExchange::endImport()
{
    disconnect(m_later);
    m_banners.clear(QLatin1String(importNotice));
}

bool FileExchange::importInto(const DeviceView &device, const QString &path)
{
    endImport();
    auto file = loadParameterFile(path, *device.family, titleOf(device));
    if (!file) {
        m_banners.post(QLatin1String(importNotice), BannerKind::Danger, file.error().cause, file.error().remedy);
        return false;
    }
    const ParameterSource source{
        *device.family, device.identity, device.selector, EditDesk::of(m_workbench).editsOf(device).entries()};
    std::vector<ParameterChange> changes;
    for (const ParameterDifference &difference : differences(source, *file)) {
        if (!difference.ofAnotherUnit)
            changes.push_back({difference.index, difference.to});
        else
            file->notes.push_back(say("%1 belongs to the unit that the file was saved from",
                device.family->parameters[difference.index.value].key));
    }
    if (changes.empty()) {
        m_banners.post(QLatin1String(importNotice), BannerKind::Info,
            tr("%1 says what the device has.").arg(fileNameOf(path)), tr("Nothing is staged."));
        return false;
    }
    stage(device, fileNameOf(path), changes, file->notes);
    return true;
}

void FileExchange::stage(const DeviceView &device, const QString &name, const std::vector<ParameterChange> &changes,
    const std::vector<Message> &leftOut)
{
    m_view.commitField();
    m_importedInto = device.id;
    StagedEdits &edits = EditDesk::of(m_workbench).editsOf(device);
    edits.stageAll(changes, tr("Import of %1").arg(name));
    QString remedy = tr("Nothing is written yet: look through the list, then write.");
    if (!leftOut.empty())
        remedy += QLatin1Char(' ')
            + tr("Left out: %1, for one: %2.").arg(leftOut.size()).arg(messageText(leftOut.front()));
    const QString cause = tr("Staged from %1: %2 of its values differ.").arg(name).arg(changes.size());
    const auto post = [this, cause, remedy, last = edits.undoStack().index()](int index) {
        if (index < last)
            endImport();
        else
            m_banners.post(QLatin1String(importNotice), BannerKind::Info, cause, remedy,
                index == last ? tr("Undo the import") : QString());
    };
    post(edits.undoStack().index());
    m_later = connect(&edits.undoStack(), &QUndoStack::indexChanged, this, post);
}

void FileExchange::exportOf(const DeviceView &device, const QString &path)
{
    m_banners.clear(QLatin1String(fileNotice));
    const QByteArray text = parameterFileText({*device.family, device.identity, device.selector, *device.parameters});
    if (const auto saved = saveFile(path.toStdString(), text); !saved)
        m_banners.post(
            QLatin1String(fileNotice), BannerKind::Danger, errorText(saved.error()), tr("Choose another place."));
    else
        m_workbench.report(
            Severity::Good, titleOf(device), tr("%1 parameters exported to %2").arg(knownOf(device)).arg(path));
}

std::optional<ParameterReference> FileExchange::referenceOf(
    const QString &path, const Family &family, const QString &owner)
{
    m_banners.clear(QLatin1String(fileNotice));
    const auto file = loadParameterFile(path, family, owner);
    if (!file) {
        m_banners.post(QLatin1String(fileNotice), BannerKind::Danger, file.error().cause, file.error().remedy);
        return std::nullopt;
    }
    ParameterReference reference{fileNameOf(path), {}};
    for (const auto &entry : entriesOf(family, *file))
        reference.raws.push_back(entry.raw);
    return reference;
}

std::optional<OpenedFile> FileExchange::open(const QString &path)
{
    m_banners.clear(QLatin1String(fileNotice));
    const auto family = loadFamily(path);
    const auto file = family ? loadParameterFile(path, **family, fileNameOf(path))
                             : FromFile<ParameterFile>(tl::unexpected<RefusedFile>(family.error()));
    if (!file) {
        m_banners.post(QLatin1String(fileNotice), BannerKind::Danger, file.error().cause, file.error().remedy);
        return std::nullopt;
    }
    OpenedFile opened{*family, fileNameOf(path), std::make_unique<StagedEdits>(**family)};
    opened.edits->setEntries(entriesOf(**family, *file));
    return opened;
}

} // namespace mb
