package org.starl.bench;

import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.gvh.GvhVariable;
import org.starl.id.Participants;
import org.starl.platform.Waits;
import org.starl.primitives.mutex.MutexFailure;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.trace.Instance;

/** One lock for a whole intersection: whichever zones a car asks for, it gets one section. */
final class OneLock implements MutexPrim {

  private static final String WHOLE = "whole";

  private final MutexPrim inner;
  private final SortedSet<String> zones = new TreeSet<>();

  /**
   * @param inner holds the lock
   */
  OneLock(MutexPrim inner) {
    this.inner = inner;
  }

  @Override
  public void do_mutex(Collection<String> sections) {
    inner.do_mutex(List.of(WHOLE));
    replace(sections);
  }

  @Override
  public void do_mutex(Collection<String> sections, Participants plist) {
    inner.do_mutex(List.of(WHOLE), plist);
    replace(sections);
  }

  @Override
  public MutexFailure acquire(Collection<String> sections, long timeoutMs) {
    MutexFailure failure = inner.acquire(List.of(WHOLE), timeoutMs);
    replace(sections);
    return failure;
  }

  @Override
  public Waits<MutexFailure> acquiring(Collection<String> sections, long timeoutMs) {
    throw new UnsupportedOperationException("the cars of this benchmark do not wait so");
  }

  @Override
  public List<Occupant> occupants() {
    return inner.occupants();
  }

  private void replace(Collection<String> sections) {
    zones.clear();
    zones.addAll(sections);
  }

  @Override
  public GvhVariable<Boolean> crit() {
    return inner.crit();
  }

  @Override
  public GvhVariable<Boolean> failed() {
    return inner.failed();
  }

  @Override
  public GvhVariable<MutexFailure> failure() {
    return inner.failure();
  }

  @Override
  public void release(Collection<String> sections) {
    zones.removeAll(sections);
    if (zones.isEmpty() && !sections.isEmpty()) {
      inner.release(WHOLE);
    }
  }

  @Override
  public void withdraw() {
    inner.withdraw();
  }

  @Override
  public void standsIn(Collection<String> sections) {
    inner.standsIn(sections.isEmpty() ? List.of() : List.of(WHOLE));
  }

  @Override
  public SortedSet<String> held() {
    return od_mutex() ? Collections.unmodifiableSortedSet(zones) : Collections.emptySortedSet();
  }

  @Override
  public Instance source() {
    return inner.source();
  }

  @Override
  public void close() {
    inner.close();
  }
}
