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
 * Bounded progress: what is owed within a bound, as long as its assumption holds. Each debt has a
 * key. A debt whose assumption breaks is suspended, and owed anew, with the whole bound, once the
 * assumption holds again: progress is promised only if the assumption holds throughout.
 *
 * <p>Time must not run backwards from call to call. Call {@link #expire} at every event, before the
 * event itself is looked at, and at the end of the run. A step costs constant time.
 *
 * @param <K> compared by {@code equals}
 */
public final class Within<K> {

  private final long boundNs;
  // All bounds are equal and time never runs backwards, so this order is that of the deadlines.
  private final Map<K, Long> sinceNs = new LinkedHashMap<>();
  private final Set<K> suspended = new LinkedHashSet<>();
  private boolean allSuspended;

  /**
   * @param boundNs not negative; what happens exactly this long after it is owed is in time
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

  /** {@code key} is owed from now on, unless it is already, suspended or not. */
  public void owe(K key, long nowNs) {
    if (!suspended.contains(key)) {
      sinceNs.putIfAbsent(key, nowNs);
    }
  }

  /**
   * {@code key} has come, or is wanted no more.
   *
   * @return whether it was owed, suspended or not
   */
  public boolean settle(K key) {
    return sinceNs.remove(key) != null || suspended.remove(key);
  }

  /** Says whether the assumption behind {@code key}'s debt holds; without a debt, nothing. */
  public void assume(K key, boolean holds, long nowNs) {
    if (holds) {
      if (suspended.remove(key)) {
        sinceNs.put(key, nowNs);
      }
    } else if (sinceNs.remove(key) != null) {
      suspended.add(key);
    }
  }

  /** As {@link #assume}, for every debt. */
  public void assumeEach(Predicate<? super K> holds, long nowNs) {
    for (Collection<K> keys : List.of(sinceNs.keySet(), suspended)) {
      List.copyOf(keys).forEach(key -> assume(key, holds.test(key), nowNs));
    }
  }

  /**
   * Says whether what all debts assume holds, those that come later too: that the world behaves
   * ({@link Circumstances#isFair}). While it does not, nothing expires.
   */
  public void assumeAll(boolean holds, long nowNs) {
    if (holds && allSuspended) {
      sinceNs.replaceAll((key, since) -> nowNs);
    }
    allSuspended = !holds;
  }

  /** Whether {@code key} is owed, suspended or not. */
  public boolean isOwed(K key) {
    return sinceNs.containsKey(key) || suspended.contains(key);
  }

  /** How much is owed and not suspended. */
  public int running() {
    return allSuspended ? 0 : sinceNs.size();
  }

  /** Ends every debt whose bound has passed before {@code nowNs}, and tells of each. */
  public void expire(long nowNs, Expired<? super K> expired) {
    if (allSuspended) {
      return;
    }
    Iterator<Map.Entry<K, Long>> oldestFirst = sinceNs.entrySet().iterator();
    while (oldestFirst.hasNext()) {
      Map.Entry<K, Long> debt = oldestFirst.next();
      long since = debt.getValue();
      if (nowNs - since <= boundNs) {
        return;
      }
      K key = debt.getKey();
      oldestFirst.remove();
      expired.expired(key, since, since + boundNs);
    }
  }

  /** Takes a debt that was not met; must not call back. */
  @FunctionalInterface
  public interface Expired<K> {
    void expired(K key, long sinceNs, long deadlineNs);
  }
}
