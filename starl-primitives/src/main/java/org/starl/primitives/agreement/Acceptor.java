package org.starl.primitives.agreement;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.AcceptorRecord.Slot;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Accepted;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Nack;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.agreement.SynodMessage.Vote;

/**
 * One voter. It writes each promise and vote to stable storage before it answers: a voter that forgets
 * a promise lets two values be decided.
 *
 * <p>Pure: it writes and answers through its {@link SynodLink}, and never blocks.
 */
final class Acceptor {

  /** The wishes in one promise take at most this many bytes, length fields included. */
  private static final int MAX_WISH_BYTES = 400;

  private static final int MAX_WISHES = 32;

  private final SynodLink link;
  private @Nullable Decided decided;
  private final TreeMap<Long, Slot> slots;

  // Hints only: not stable, and no safety argument uses them.
  private final TreeMap<Long, Map<RobotId, Value>> wishes = new TreeMap<>();

  private long version;
  private long flushedVersion;
  private final Queue<Waiting> waiting = new ArrayDeque<>();

  Acceptor(AcceptorRecord record, SynodLink link) {
    this.link = link;
    this.decided = record.decided();
    this.slots = new TreeMap<>(record.slots());
  }

  /** An answer that waits until its version is flushed. */
  private record Waiting(long version, RobotId to, SynodMessage answer) {}

  /** The latest decree known to this acceptor, or null. */
  @Nullable Decided decided() {
    return decided;
  }

  /** {@code Synod_decls.Prepared}. */
  void prepare(RobotId from, Prepare m) {
    Decided known = decided;
    if (known != null && known.number() >= m.number()) {
      link.send(from, known);
      return;
    }
    keepWish(from, m);
    Slot slot = slots.get(m.number());
    if (slot != null && m.ballot().compareTo(slot.promised()) < 0) {
      link.send(from, new Nack(m.number(), m.ballot(), slot.promised()));
      return;
    }
    Vote vote = slot == null ? null : slot.vote();
    // Equal ballots: the same message again. The promise is repeated, nothing changes.
    if (slot == null || !slot.promised().equals(m.ballot())) {
      write(m.number(), new Slot(m.ballot(), vote));
    }
    List<Value> heard = vote == null ? wishesFor(m.number()) : List.of();
    answerOnceFlushed(from, new Promise(m.number(), m.ballot(), vote, heard));
  }

  /** {@code Synod_decls.Accept}. */
  void accept(RobotId from, Accept m) {
    Decided known = decided;
    if (known != null && known.number() >= m.number()) {
      link.send(from, known);
      return;
    }
    Slot slot = slots.get(m.number());
    if (slot != null && m.ballot().compareTo(slot.promised()) < 0) {
      link.send(from, new Nack(m.number(), m.ballot(), slot.promised()));
      return;
    }
    Slot voted = new Slot(m.ballot(), new Vote(m.ballot(), m.value()));
    if (!voted.equals(slot)) {
      write(m.number(), voted);
    }
    answerOnceFlushed(from, new Accepted(m.number(), m.ballot()));
  }

  /** Learns a decree later than the one it knows, and drops the slots and wishes that it settles. */
  void decided(Decided m) {
    decided = m;
    slots.headMap(m.number(), true).clear();
    wishes.headMap(m.number(), true).clear();
    persist();
  }

  /** Versions up to {@code flushed} would survive a crash. */
  void flushed(long flushed) {
    flushedVersion = Math.max(flushedVersion, flushed);
    while (!waiting.isEmpty() && waiting.element().version() <= flushedVersion) {
      Waiting next = waiting.remove();
      link.send(next.to(), next.answer());
    }
  }

  /** The state: acceptors with equal texts behave alike. */
  String state() {
    StringBuilder text = new StringBuilder();
    text.append(decided).append(slots).append(wishes).append(version - flushedVersion);
    for (Waiting each : waiting) {
      text.append(each.version() - flushedVersion).append(each.to()).append(each.answer());
    }
    return text.toString();
  }

  private void write(long number, Slot slot) {
    slots.put(number, slot);
    persist();
  }

  private void persist() {
    version++;
    link.persist(version, new AcceptorRecord(decided, slots).toBytes());
  }

  private void answerOnceFlushed(RobotId to, SynodMessage answer) {
    if (version <= flushedVersion) {
      link.send(to, answer);
    } else {
      Waiting one = new Waiting(version, to, answer);
      // A repeated question needs no second answer, and a slow disk no longer queue.
      if (!waiting.contains(one)) {
        waiting.add(one);
      }
    }
  }

  private void keepWish(RobotId from, Prepare m) {
    if (m.wish().length() > 0) {
      wishes.computeIfAbsent(m.number(), n -> new LinkedHashMap<>()).put(from, m.wish());
    }
  }

  private List<Value> wishesFor(long number) {
    List<Value> fitting = new ArrayList<>();
    int bytes = 0;
    for (Value wish : wishes.getOrDefault(number, Map.of()).values()) {
      bytes += wish.length() + Short.BYTES;
      if (bytes > MAX_WISH_BYTES || fitting.size() == MAX_WISHES) {
        break;
      }
      fitting.add(wish);
    }
    return fitting;
  }
}
