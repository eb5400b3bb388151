#include "core/base/progress.h"

#include "core/base/result.h"

namespace nineline {

Error cancelled() { return noAnswer("cancelled", "Cancelled; nothing was changed."); }

}  // namespace nineline
