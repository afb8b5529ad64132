package org.starl.primitives.registration;

import java.util.Set;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;

/**
 * Builds the next view from the decided one, change by change. A change that does not fit, or would
 * break the rule of confinement, is left to a later view.
 */
final class Proposal {

  private final View decided;
  private View next;

  // Fencers of confinements in this view: they may not leave.
  private final Set<ProcessId> vouching = new TreeSet<>();

  Proposal(View decided) {
    this.decided = decided;
    this.next = decided.next();
  }

  View view() {
    return next;
  }

  /** Applies as much of {@code change} as possible. */
  Proposal add(Change change) {
    for (ProcessId id : change.leave()) {
      if (!vouching.contains(id)) {
        take(next.without(id));
      }
    }
    ProcessId join = change.join();
    if (join != null && ViewFormat.fitsWithRoom(next.with(join))) {
      next = next.with(join);
    }
    for (Confinement confinement : change.confine()) {
      confine(confinement);
    }
    return this;
  }

  private void confine(Confinement confinement) {
    boolean counts =
        confinement.changes(next)
            && !vouching.contains(confinement.who())
            && confinement.hasFencersIn(decided)
            && confinement.hasFencersIn(next);
    if (counts && take(confinement.applyTo(next))) {
      vouching.addAll(confinement.fencers());
    }
  }

  private boolean take(View more) {
    boolean fits = ViewFormat.fits(more);
    next = fits ? more : next;
    return fits;
  }
}
