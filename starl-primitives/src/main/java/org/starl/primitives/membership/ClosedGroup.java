package org.starl.primitives.membership;

import java.util.SortedSet;
import org.starl.id.ProcessId;

/**
 * A fixed list: nobody joins, leaves or is given up, so any number of members may act by it. A robot
 * whose program has started anew is somebody else, and not in the list.
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
    // Nobody leaves.
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
    throw new IllegalStateException("a closed group gives nobody up: " + confinement);
  }

  @Override
  public void isIdleForEver(ProcessId id) {
    // It stays in the list.
  }

  @Override
  public void standsIn(SortedSet<String> sections) {
    // Who it was stays in the list.
  }
}
