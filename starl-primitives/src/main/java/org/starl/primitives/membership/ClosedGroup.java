package org.starl.primitives.membership;

import java.util.SortedSet;
import org.starl.id.ProcessId;

/**
 * A fixed list. No participant joins, leaves or is given up, so it may have several users. A robot whose
 * program has restarted has another id, which is not in the list.
 */
record ClosedGroup(ProcessId me, View view) implements Membership {

  @Override
  public boolean mayRequest() {
    return view.contains(me);
  }

  @Override
  public void onChange(Runnable listener) {
    // It never changes.
  }

  @Override
  public void join(Member member) {
    // No participant leaves.
  }

  @Override
  public void refresh() {
    // There is no later view.
  }

  @Override
  public boolean confines() {
    return false;
  }

  @Override
  public void propose(Confinement confinement) {
    throw new IllegalStateException("a closed group gives up no participant: " + confinement);
  }

  @Override
  public void markIdle(ProcessId id) {
    // It stays in the list.
  }

  @Override
  public void standsIn(SortedSet<String> sections) {
    // The earlier ids stay in the list.
  }
}
