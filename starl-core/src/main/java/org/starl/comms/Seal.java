package org.starl.comms;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.session.Session;
import org.starl.session.Sessions;

/**
 * Seals this robot's datagrams, and opens those of others so that each is accepted once. For each
 * session the {@link #WINDOW} highest counts are tracked individually; older ones are dropped.
 * Strand only.
 */
final class Seal {

  static final int WINDOW = 1024;

  private final Sessions sessions;
  // Never iterated. Only a robot with a session has an entry, so an attacker cannot fill it.
  private final Map<RobotId, Inbound> inbound = new HashMap<>();
  private byte[] sealed = new byte[256];
  private byte[] opened = new byte[256];

  Seal(Sessions sessions) {
    this.sessions = sessions;
  }

  /** The last sealed datagram; valid until the next one. */
  byte[] buffer() {
    return sealed;
  }

  /**
   * Seals a datagram for {@code to} into {@link #buffer}.
   *
   * @return the sealed datagram's length in bytes; 0 if there is no session with {@code to}
   */
  int seal(RobotId to, byte[] datagram, int length) {
    Session session = sessions.with(to);
    if (session == null) {
      return 0;
    }
    if (sealed.length < length + Session.BYTES) {
      sealed = new byte[length + Session.BYTES];
    }
    session.seal(datagram, Header.bodyAt(datagram), length, sealed);
    return length + Session.BYTES;
  }

  /** The receivers of a broadcast, in order. */
  Iterable<RobotId> peers() {
    return sessions.peers();
  }

  /**
   * Opens a sealed datagram, whose header was parsed; the header then reads the opened bytes.
   *
   * @param length of the sealed datagram
   * @return why to drop it, or null if it is genuine and arrives for the first time
   */
  @Nullable DropReason open(RobotId from, Header header, int length) {
    Session session = sessions.with(from);
    if (session == null) {
      return DropReason.NO_SESSION;
    }
    if (!session.isOf(header.bytes, length)) {
      return DropReason.OTHER_SESSION;
    }
    if (opened.length < length) {
      opened = new byte[length];
    }
    long count = Session.count(header.bytes, length);
    if (count <= 0 || !session.open(header.bytes, header.bodyAt, length, opened)) {
      return DropReason.FORGED;
    }
    SlidingWindow arrived = arrived(from, session);
    if (arrived.isTooOld(count) || arrived.contains(count)) {
      return DropReason.REPLAYED;
    }
    arrived.add(count);
    header.continueIn(opened);
    return null;
  }

  private SlidingWindow arrived(RobotId from, Session session) {
    Inbound present = inbound.get(from);
    if (present == null || present.session != session) {
      present = new Inbound(session, new SlidingWindow(WINDOW));
      inbound.put(from, present);
    }
    return present.arrived;
  }

  private record Inbound(Session session, SlidingWindow arrived) {}
}
