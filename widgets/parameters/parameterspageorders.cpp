// SPDX-License-Identifier: GPL-3.0-or-later
// What the page orders: reads, writes, stores; files in and out.
#include "files/filebytes.h"
#include "widgets/common/banner.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/segmented.h"
#include "widgets/parameters/changespanel.h"
#include "widgets/parameters/parameterfiles.h"
#include "widgets/parameters/parameterspage.h"

#include <QPointer>
#include <QStackedWidget>

namespace mb {
namespace {

// Notices of this page, in the strip of the window.
constexpr auto writeKey = "parameters write";
constexpr auto importKey = "parameters import";
constexpr auto fileKey = "parameters file";

} // namespace

/// Also after another device or page was chosen: it says of which device it speaks.
void ParametersPage::refuse(const char *key, DeviceId device, const QString &cause, const QString &remedy)
{
    const DeviceView *of = m_workbench.snapshot().device(device);
    m_banners.post(
        QLatin1String(key), BannerKind::Danger, of ? titleOf(*of) + QStringLiteral(": ") + cause : cause, remedy);
}

/// The only button of this page's notices: "Undo the import".
void ParametersPage::act(const QString &key)
{
    if (key != QLatin1String(importKey))
        return;
    m_banners.clear(key);
    m_view->commitField();
    if (StagedEdits *edits = m_desk.find(m_importedInto))
        edits->undoStack().undo();
}

void ParametersPage::readAll()
{
    const DeviceView *shown = device();
    if (shown && m_read->isEnabled() && m_model->edits() && !m_fileEdits)
        m_workbench.send(orders::ReadParameters{shown->id});
}

void ParametersPage::write()
{
    if (!m_model->edits() || m_fileEdits)
        return;
    m_view->commitField();
    refresh();
    if (!m_panel->mayWrite())
        return;
    m_banners.clear(QLatin1String(writeKey));
    m_banners.clear(QLatin1String(importKey));
    const DeviceId id = m_selection.device();
    const auto changes = m_model->edits()->toWrite();
    m_workbench.send(orders::WriteParameters{id, changes},
        [page = QPointer<ParametersPage>(this), id, changes](const Result<void> &result) {
            if (page)
                page->written(id, changes, result);
        });
}

void ParametersPage::written(DeviceId device, const std::vector<ParameterChange> &sent, const Result<void> &result)
{
    if (StagedEdits *edits = m_desk.find(device); result && edits)
        edits->settle(sent);
    if (!result)
        refuse(writeKey, device, errorText(result.error()),
            tr("What was written before it is in force; the rest is still staged. Nothing was stored."));
    refresh();
}

void ParametersPage::store()
{
    const DeviceView *shown = device();
    if (!shown)
        return;
    m_banners.clear(QLatin1String(writeKey));
    m_workbench.send(
        orders::StoreParameters{shown->id}, [page = QPointer(this), id = shown->id](const Result<void> &result) {
            if (page && !result)
                page->refuse(writeKey, id, errorText(result.error()),
                    tr("Nothing is proved to be in flash. Store again, and keep power on."));
        });
}

void ParametersPage::importFrom(const QString &path)
{
    const DeviceView *shown = device();
    if (!shown || !m_model->edits() || m_fileEdits)
        return;
    m_banners.clear(QLatin1String(importKey));
    auto file = loadParameterFile(path, *shown->family, titleOf(*shown));
    if (!file) {
        m_banners.post(QLatin1String(importKey), BannerKind::Danger, file.error().cause, file.error().remedy);
        return;
    }
    const ParameterSource source{*shown->family, shown->identity, shown->selector, m_model->edits()->entries()};
    std::vector<ParameterChange> changes;
    for (const ParameterDifference &difference : differences(source, *file)) {
        if (!difference.ofAnotherUnit)
            changes.push_back({difference.index, difference.to});
        else
            file->notes.push_back(say("%1 belongs to the unit that the file was saved from",
                shown->family->parameters[difference.index.value].key));
    }
    if (changes.empty()) {
        m_banners.post(QLatin1String(importKey), BannerKind::Info,
            tr("%1 says what the device has.").arg(fileNameOf(path)), tr("Nothing is staged."));
        return;
    }
    m_view->commitField();
    m_importedInto = shown->id;
    m_model->edits()->stageAll(changes, tr("Import of %1").arg(fileNameOf(path)));
    QString remedy = tr("Nothing is written yet: look through the list, then write.");
    if (!file->notes.empty())
        remedy += QLatin1Char(' ')
            + tr("Left out: %1, for one: %2.").arg(file->notes.size()).arg(messageText(file->notes.front()));
    m_banners.post(QLatin1String(importKey), BannerKind::Info,
        tr("Staged from %1: %2 of its values differ.").arg(fileNameOf(path)).arg(changes.size()), remedy,
        tr("Undo the import"));
    m_segments->setCurrent(ParameterFilter::Edited);
}

void ParametersPage::exportTo(const QString &path)
{
    const DeviceView *shown = device();
    if (!shown)
        return;
    m_banners.clear(QLatin1String(fileKey));
    const QByteArray text = parameterFileText({*shown->family, shown->identity, shown->selector, shown->parameters});
    if (const auto saved = saveFile(path.toStdString(), text); !saved)
        m_banners.post(
            QLatin1String(fileKey), BannerKind::Danger, errorText(saved.error()), tr("Choose another place."));
    else
        m_workbench.report(Severity::Good, titleOf(*shown),
            tr("%1 parameters exported to %2").arg(shown->parameters.size()).arg(path));
}

void ParametersPage::compareWith(const QString &path)
{
    const Family *family = m_model->family();
    if (!family)
        return;
    m_banners.clear(QLatin1String(fileKey));
    const auto file = loadParameterFile(path, *family, device() && !m_fileEdits ? titleOf(*device()) : m_fileName);
    if (!file) {
        m_banners.post(QLatin1String(fileKey), BannerKind::Danger, file.error().cause, file.error().remedy);
        fillComparisons();
        return;
    }
    ParameterReference reference{fileNameOf(path), {}};
    for (const auto &entry : entriesOf(*family, *file))
        reference.raws.push_back(entry.raw);
    m_fileReference = reference;
    m_model->setReference(std::move(reference));
    fillComparisons();
}

void ParametersPage::openFile(const QString &path)
{
    m_banners.clear(QLatin1String(fileKey));
    const auto family = loadFamily(path);
    const auto file = family ? loadParameterFile(path, **family, fileNameOf(path))
                             : FromFile<ParameterFile>(tl::unexpected<RefusedFile>(family.error()));
    if (!file) {
        m_banners.post(QLatin1String(fileKey), BannerKind::Danger, file.error().cause, file.error().remedy);
        return;
    }
    auto edits = std::make_unique<StagedEdits>(**family);
    edits->setEntries(entriesOf(**family, *file));
    m_model->show(*family, edits.get(), false);
    m_fileEdits = std::move(edits);
    m_fileName = fileNameOf(path);
    m_fileReference.reset();
    m_panel->hide();
    m_stack->setCurrentIndex(1);
    fillComparisons();
    setFilter();
}

} // namespace mb
