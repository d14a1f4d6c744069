// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/linkload.h"
#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QWidget>

#include <map>

class QGridLayout;
class QScrollArea;
class QStackedWidget;

namespace mb {

class Card;
class DeviceCard;
class DoctorCard;
class Sparkline;
class StartPage;
class ValueLabel;

/// Every link and every device at a glance; with nothing connected, why that is and what can be done.
class OverviewPage : public QWidget {
    Q_OBJECT
public:
    OverviewPage(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent = nullptr);

    /// What is shown while no link is open.
    [[nodiscard]] StartPage &start() { return *m_start; }
    /// Above the cards; the page takes it.
    void addOffer(QWidget *offer);

Q_SIGNALS:
    void simulateRequested();
    void addLinkRequested();
    void openRecordingRequested();
    /// The card of a device in its bootloader asks for the Firmware page.
    void updateRequested();

protected:
    void showEvent(QShowEvent *) override { follow(); }
    void resizeEvent(QResizeEvent *) override { arrange(); }

private:
    struct LinkCard {
        Card *card = nullptr;
        ValueLabel *load = nullptr;
        ValueLabel *errors = nullptr;
        ValueLabel *lost = nullptr;
        ValueLabel *unknown = nullptr;
        ValueLabel *roundTrip = nullptr; ///< of serial links
        Sparkline *line = nullptr;
    };

    void buildCards();
    void buildEmpty();
    void follow();
    void followLinks(const Snapshot &shot);
    void followDevices(const Snapshot &shot);
    void followOrder(const Snapshot &shot);
    void goToChosen();
    [[nodiscard]] int fittingColumns(int widest) const;
    void arrange();
    [[nodiscard]] LinkCard makeLinkCard(const LinkView &link);

    Workbench &m_workbench;
    Selection &m_selection;
    const ThemeSource &m_theme;
    QStackedWidget *m_states = nullptr;
    QWidget *m_canvas = nullptr;
    QGridLayout *m_linkGrid = nullptr;
    QGridLayout *m_deviceGrid = nullptr;
    LinkLoads m_loads;
    StartPage *m_start = nullptr;   ///< of the empty page
    DoctorCard *m_ailing = nullptr; ///< above the cards: what does not work
    std::map<std::string, LinkCard> m_links;
    std::map<DeviceId, DeviceCard *> m_cards;
    std::vector<DeviceId> m_order; ///< of the cards
    int m_columns = 0;
    int m_linkColumns = 0;
};

} // namespace mb
