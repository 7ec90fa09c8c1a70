#include "rt/render/accel/box_list.h"

namespace rt {

BoxList::BoxList(const std::vector<Bounds>& boxes) : space_(boxes) {
  groups_.resize((boxes.size() + BoxGroup::width - 1) / BoxGroup::width);
  for (std::size_t i = 0; i < BoxGroup::width * groups_.size(); ++i) {
    BoxSpace::put(groups_[i / BoxGroup::width], i % BoxGroup::width,
                  i < boxes.size() ? space_.box(boxes[i]) : BoxSpace::nothing());
  }
}

}  // namespace rt
