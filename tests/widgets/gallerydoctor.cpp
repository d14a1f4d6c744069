// SPDX-License-Identifier: GPL-3.0-or-later
#include "gallery.h"
#include "support/fakeworkbench.h"
#include "widgets/connection/overviewpage.h"

#include <QVBoxLayout>

using namespace mb;

namespace {

LinkListing listing(const char *path, ListingState state, const char *detail, const Diagnosis &found = {})
{
    return {{"socketcan", path, {}}, LinkKind::Can, state,
        found.isHealthy() ? Message::verbatim(detail) : found.message(), found.isHealthy(), found, false};
}

LinkView link(const char *address, const char *name, LinkState state, const Diagnosis &found = {})
{
    LinkView view;
    view.address = address;
    view.name = name;
    view.state = state;
    view.reason = found.cause;
    view.bitrate = 1'000'000;
    view.load = 0.14;
    view.diagnosis = found;
    return view;
}

} // namespace

QWidget *doctorPage(const ThemeSource &theme, bool empty)
{
    auto *page = new QWidget;
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    auto *workbench = new test::FakeWorkbench(page);
    auto *selection = new Selection(page);
    const Diagnosis down{Ailment::Down, say("can2 is switched off"), say("bring it up"),
        "sudo ip link set can2 up type can bitrate 1000000"};
    const Diagnosis alone{Ailment::NobodyAcknowledges, say("nobody acknowledges what can0 sends"),
        say("switch the devices on, check the cable and that two 120 Ω resistors end the bus, and that every device "
            "has the bit rate 1 Mbit/s"),
        {}};
    const Diagnosis gone{Ailment::Gone, say("can1 is gone"),
        say("plug the adapter in again; the link is opened by itself as soon as it is up"), {}};
    workbench->links = {listing("can0", ListingState::Up, "gs_usb, 1 Mbit/s, sample point 87.5 %"),
        listing("can2", ListingState::Down, "", down)};
    if (!empty)
        workbench->shot.links = {link("socketcan:can0", "can0", LinkState::Open, alone),
            link("socketcan:can1", "can1", LinkState::Lost, gone)};
    column->addWidget(new OverviewPage(*workbench, *selection, theme, page));
    return page;
}
