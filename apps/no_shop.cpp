// SPDX-License-Identifier: MIT
// A build without the shop.
#include "apps/shop/shop_commands.hpp"

namespace camopt::apps {

void add_shop_commands(Commands& /*commands*/) {}

std::vector<ListTopic> shop_topics() {
    return {};
}

std::vector<DescribedKeys> shop_keys() {
    return {};
}

}  // namespace camopt::apps
