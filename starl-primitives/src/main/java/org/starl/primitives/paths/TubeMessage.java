package org.starl.primitives.paths;

import org.starl.id.RobotId;

/** What is said about tubes. All are idempotent: each may be lost, late, doubled and reordered. */
sealed interface TubeMessage {

  /** The sender's version that this is about, or answers. */
  long version();

  /** This is what I hold and want; forget what I said in older versions. */
  record Ask(Holding holding) implements TubeMessage {
    @Override
    public long version() {
      return holding.version();
    }
  }

  /** I have noted it, and what you want meets nothing that I know of. */
  record Vote(long version) implements TubeMessage {}

  /**
   * I have noted what you hold, not what you want: it meets what {@code who} holds or wants.
   *
   * @param theirs {@link Holding#NONE} if {@code who} has not said yet where it stands
   */
  record Refuse(long version, RobotId who, Holding theirs) implements TubeMessage {}
}
