package org.starl.robot.udp;

import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLongArray;

/**
 * Counts dropped datagrams by reason. From any thread.
 *
 * @param <R> the reasons
 */
public final class DropCounts<R extends Enum<R>> {

  private final Class<R> reasons;
  private final AtomicLongArray counts;

  public DropCounts(Class<R> reasons) {
    this.reasons = reasons;
    counts = new AtomicLongArray(reasons.getEnumConstants().length);
  }

  /** Counts one; true if it is the first for this reason, which is worth a line in the log. */
  public boolean add(R reason) {
    return counts.incrementAndGet(reason.ordinal()) == 1;
  }

  /** The counts so far; reasons without any are left out. */
  public Map<R, Long> counts() {
    Map<R, Long> copy = new EnumMap<>(reasons);
    for (R reason : reasons.getEnumConstants()) {
      if (counts.get(reason.ordinal()) > 0) {
        copy.put(reason, counts.get(reason.ordinal()));
      }
    }
    return Collections.unmodifiableMap(copy);
  }
}
