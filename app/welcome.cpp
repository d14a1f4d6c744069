// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/welcome.h"

#include "app/firmwareshelf.h"
#include "app/helpdesk.h"
#include "app/mainwindow.h"
#include "app/settings.h"
#include "model/registry.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/pagekeys.h"
#include "widgets/connection/overviewpage.h"
#include "widgets/connection/startpage.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/help/helptopics.h"
#include "widgets/start/guide.h"
#include "widgets/start/guidestrip.h"

#include <QBoxLayout>

#include <algorithm>

namespace mb {
namespace {

PageId pageOf(StoryPlace place)
{
    switch (place) {
    case StoryPlace::Overview: return PageId::Overview;
    case StoryPlace::Parameters: return PageId::Parameters;
    case StoryPlace::Tune: return PageId::Tune;
    case StoryPlace::Design: return PageId::Design;
    }
    return PageId::Overview;
}

} // namespace

Welcome::Welcome(MainWindow &window, Workbench &workbench, const ThemeSource &theme, Settings &settings)
    : QObject(&window)
    , m_window(window)
    , m_workbench(workbench)
    , m_settings(settings)
    , m_start(&qobject_cast<OverviewPage *>(window.page(PageId::Overview))->start())
    , m_guide(new Guide(workbench, window.selection(), window.arming(), this))
    , m_offer(new GuideStrip(GuideStrip::Shows::Offers, *m_guide, theme, window.page(PageId::Overview)))
    , m_strip(new GuideStrip(GuideStrip::Shows::Steps, *m_guide, theme, &window))
    , m_shelf(new FirmwareShelf(settings.firmwareFolder(), this))
{
    window.addAbovePages(*m_strip);
    qobject_cast<OverviewPage *>(window.page(PageId::Overview))->addOffer(m_offer);
    connectStart();
    connectStrip();
    connect(&workbench, &Workbench::changed, this, &Welcome::offer);
}

void Welcome::connectStart()
{
    connect(m_start, &StartPage::storyWanted, this, &Welcome::begin);
    connect(m_start, &StartPage::keysWanted, &m_window, &MainWindow::listKeys);
    connect(m_start, &StartPage::guidesWanted, this,
        [this] { (void)m_window.help().open(hardwareTopic(families().front()->key)); });
    connect(m_shelf, &FirmwareShelf::changed, this, [this] { m_start->setFirmware(m_shelf->rows()); });
    connect(m_start, &StartPage::firmwareWanted, this, [this](int row) {
        m_window.showPage(PageId::Firmware);
        qobject_cast<FirmwarePage *>(m_window.page(PageId::Firmware))->loadImage(m_shelf->path(row));
    });
    connect(m_start, &StartPage::firmwareFolderWanted, this, [this] {
        askForFolder(m_window, tr("Folder with firmware"), m_shelf->folder(), [this](const QString &folder) {
            m_settings.setFirmwareFolder(folder);
            m_shelf->look(folder);
        });
    });
    m_shelf->look(m_shelf->folder());
}

void Welcome::connectStrip()
{
    connect(m_offer, &GuideStrip::wanted, this, &Welcome::begin);
    connect(m_strip, &GuideStrip::placeWanted, this, &Welcome::show);
    m_strip->setKeys([this](const StoryStep &step) {
        return keyShown(*m_window.page(pageOf(step.place)), QString::fromLatin1(step.key));
    });
    connect(m_offer, &GuideStrip::refused, this, [this] { m_settings.dismiss(QStringLiteral("story")); });
}

void Welcome::begin(const Story &story)
{
    const auto &links = m_workbench.snapshot().links;
    const bool open = std::ranges::any_of(links, [](const LinkView &link) { return link.simulated; });
    if (!open) {
        LinkAddress address;
        address.scheme = "sim";
        m_workbench.send(orders::OpenLink{address});
    }
    m_settings.dismiss(QStringLiteral("story"));
    m_guide->begin(story);
}

void Welcome::show(StoryPlace place)
{
    if (const DeviceView *device = m_guide->device())
        m_window.selection().select(device->id);
    m_window.showPage(pageOf(place));
}

/// On the overview of a simulated bench that somebody sees for the first time.
void Welcome::offer()
{
    if (stories().empty())
        return;
    const Story &story = stories().front();
    const bool here = Guide::deviceOf(story, m_workbench.snapshot());
    m_begun = m_begun || Guide::isBegun(story, m_workbench.snapshot());
    const bool asked = m_settings.isDismissed(QStringLiteral("story"));
    m_offer->offer(here && !asked && !m_begun ? &story : nullptr);
}

} // namespace mb
