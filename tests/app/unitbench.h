// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine.h"
#include "model/registry.h"
#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/firmware/queueboard.h"
#include "widgets/firmware/queuemodel.h"

#include <QTest>

namespace mb::test {

/// Units of one family on a bench of their own, behind the page.
struct UnitBench {
    UnitBench(const char *key, std::vector<std::string> units)
        : texts(std::move(units))
        , family(*findFamily(families(), key))
    {
        show({texts.begin(), texts.end()});
        engine = std::make_unique<Engine>(only, false);
        page = std::make_unique<FirmwarePage>(*engine, selection, families(), theme);
        page->showQueue(true);
        page->resize(1280, 720);
        page->show();
    }
    ~UnitBench()
    {
        page.reset();
        engine.reset();
    }
    UnitBench(const UnitBench &) = delete;
    UnitBench &operator=(const UnitBench &) = delete;
    /// What a link that is opened next finds.
    void show(std::vector<std::string_view> bench)
    {
        views = std::move(bench);
        family.bench = views;
    }
    void open(const std::string &link) { engine->send(orders::OpenLink{*LinkAddress::parse(link)}); }
    [[nodiscard]] std::size_t found() const { return engine->snapshot().devices.size(); }
    [[nodiscard]] QueueBoard &board() const { return page->queue(); }
    [[nodiscard]] std::vector<QueueLine> in(service::RowState state) const
    {
        std::vector<QueueLine> lines;
        for (const QueueLine &line : board().model().lines()) {
            if (line.row != 0 && line.state == state)
                lines.push_back(line);
        }
        return lines;
    }
    std::vector<std::string> texts;
    std::vector<std::string_view> views;
    Family family;
    std::array<const Family *, 1> only{&family};
    ThemeSource theme{darkTheme()};
    Selection selection;
    std::unique_ptr<Engine> engine;
    std::unique_ptr<FirmwarePage> page;
};

} // namespace mb::test
