package org.starl.spec;

import java.util.Collection;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;

/**
 * Bounded progress: deadlines that apply as long as their assumption holds. Each deadline has a
 * key. A deadline whose assumption breaks is suspended, and starts again with the full bound once
 * the assumption holds again, because progress is required only if the assumption holds throughout.
 *
 * <p>Times must not decrease from call to call. Call {@link #expire} at every event, before
 * processing the event, and at the end of the run. Each call takes constant time per affected
 * deadline.
 *
 * @param <K> compared by {@code equals}
 */
public class Within<K> {

  private final long boundNs;
  // All bounds are equal and times never decrease, so this is the order of the deadlines.
  private final Map<K, Long> sinceNs = new LinkedHashMap<>();
  private final Set<K> suspended = new LinkedHashSet<>();
  private boolean allSuspended;
  // No deadline began before this. Asked at every event.
  private long oldestNs = Long.MAX_VALUE;

  /**
   * @param boundNs at least 0; an event exactly this long after the start of its deadline is in
   *     time
   */
  public Within(long boundNs) {
    if (boundNs < 0) {
      throw new IllegalArgumentException("bound " + boundNs + " ns: expected 0 or above");
    }
    this.boundNs = boundNs;
  }

  public long boundNs() {
    return boundNs;
  }

  /** Starts a deadline for {@code key}, unless it has one, suspended or not. */
  public void start(K key, long nowNs) {
    if (!suspended.contains(key) && sinceNs.putIfAbsent(key, nowNs) == null) {
      began(nowNs);
    }
  }

  private void began(long nowNs) {
    oldestNs = Math.min(oldestNs, nowNs);
  }

  /**
   * Ends the deadline of {@code key}: it was met, or is no longer required.
   *
   * @return whether there was one, suspended or not
   */
  public boolean stop(K key) {
    return sinceNs.remove(key) != null || suspended.remove(key);
  }

  /** Ends every deadline: none is required any more. */
  public void clear() {
    sinceNs.clear();
    suspended.clear();
  }

  /**
   * Sets whether the assumption of {@code key}'s deadline holds; without a deadline, does nothing.
   */
  public void assume(K key, boolean holds, long nowNs) {
    if (holds) {
      if (suspended.remove(key)) {
        sinceNs.put(key, nowNs);
        began(nowNs);
      }
    } else if (sinceNs.remove(key) != null) {
      suspended.add(key);
    }
  }

  /** As {@link #assume}, for every deadline. */
  public void assumeEach(Predicate<? super K> holds, long nowNs) {
    for (Collection<K> keys : List.of(sinceNs.keySet(), suspended)) {
      List.copyOf(keys).forEach(key -> assume(key, holds.test(key), nowNs));
    }
  }

  /**
   * Sets whether the assumption of all deadlines, including later ones, holds: that no fault is
   * active ({@link FaultState#isFaultFree}). While it does not hold, no deadline expires.
   */
  public void assumeAll(boolean holds, long nowNs) {
    if (holds && allSuspended) {
      sinceNs.replaceAll((key, since) -> nowNs);
    }
    allSuspended = !holds;
  }

  /**
   * Removes every deadline that passed before {@code nowNs}, and reports each to {@code expired}.
   */
  public void expire(long nowNs, Expired<? super K> expired) {
    if (allSuspended || nowNs - oldestNs <= boundNs) {
      return;
    }
    Iterator<Map.Entry<K, Long>> oldestFirst = sinceNs.entrySet().iterator();
    while (oldestFirst.hasNext()) {
      Map.Entry<K, Long> deadline = oldestFirst.next();
      long since = deadline.getValue();
      if (nowNs - since <= boundNs) {
        oldestNs = since;
        return;
      }
      K key = deadline.getKey();
      oldestFirst.remove();
      expired.expired(key, since, since + boundNs);
    }
    oldestNs = Long.MAX_VALUE;
  }

  /** Receives a missed deadline; must not call back. */
  @FunctionalInterface
  public interface Expired<K> {
    void expired(K key, long sinceNs, long deadlineNs);
  }
}
