package org.starl.primitives.paths;

import org.starl.id.RobotId;

/** Messages about tubes. All are idempotent: they may be lost, late, duplicated and reordered. */
sealed interface TubeMessage {

  /** The version of the holding that the message contains or answers. */
  long version();

  /** The sender's tubes; replaces older versions. */
  record Ask(Holding holding) implements TubeMessage {
    @Override
    public long version() {
      return holding.version();
    }
  }

  /** The sender has stored the holding; its wanted tube meets no tube that the sender knows. */
  record Vote(long version) implements TubeMessage {}

  /**
   * The sender has noted the held tubes only: the wanted one meets a tube that {@code who} holds or
   * wants.
   *
   * @param theirs the tubes of {@code who}; {@link Holding#NONE} if its place is not known yet
   */
  record Refuse(long version, RobotId who, Holding theirs) implements TubeMessage {}
}
