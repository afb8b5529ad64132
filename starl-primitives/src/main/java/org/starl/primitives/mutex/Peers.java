package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.mutex.MutexMessage.Rem;
import org.starl.primitives.mutex.MutexMessage.Req;

/** One participant's record of the newest requests of others, and of its answers. */
final class Peers {

  /** The newest request of another participant. */
  static final class Peer {
    private long seen;
    private boolean done;
    private boolean inOrder;
    // What it holds or waits for; what was granted; and of that, what it may still hold.
    private SortedSet<String> want = Sections.NONE;
    private SortedSet<String> granted = Sections.NONE;
    private SortedSet<String> open = Sections.NONE;
    // Of what was granted: the sections of which this process takes a place itself.
    private SortedSet<String> counted = Sections.NONE;
    // What was granted because its body is there.
    private SortedSet<String> inside = Sections.NONE;

    private void begin(long num, SortedSet<String> sections) {
      seen = num;
      done = false;
      want = sections;
      granted = Sections.NONE;
      open = Sections.NONE;
      counted = Sections.NONE;
      inside = Sections.NONE;
    }

    /** It holds these already, without a consent that is asked now. */
    private void holds(SortedSet<String> sections) {
      open = Sections.common(want, Sections.union(open, sections));
    }

    /** All sections of its newest request that were granted. */
    SortedSet<String> granted() {
      return granted;
    }

    /** Of these, the ones of which this process takes a place itself. */
    SortedSet<String> counted() {
      return counted;
    }

    /** Whether it needs no further answer to {@code req}. */
    boolean hasAll(Req req) {
      return granted.containsAll(req.waits()) && !Sections.meet(counted, req.waits());
    }

    void grant(SortedSet<String> sections, SortedSet<String> nowCounted) {
      granted = Sections.union(granted, sections);
      counted = nowCounted;
      SortedSet<String> all = Sections.union(open, sections);
      open = inOrder ? Sections.common(want, all) : all;
    }
  }

  private final TreeMap<ProcessId, Peer> peers = new TreeMap<>();
  private final Map<ProcessId, Req> pending = new LinkedHashMap<>();

  /** Records {@code req}; null if it is stale or withdrawn, and must not be answered. */
  @Nullable Peer hear(Req req) {
    Peer peer = peers.computeIfAbsent(req.from(), id -> new Peer());
    if (req.num() < peer.seen || (req.num() == peer.seen && peer.done)) {
      return null;
    }
    if (req.num() > peer.seen) {
      peer.begin(req.num(), req.want());
      peer.inOrder = req.inOrder();
      pending.remove(req.from());
    }
    if (!req.wish().holds().isEmpty()) {
      peer.holds(req.wish().holds());
      peer.inside = Sections.common(req.waits(), req.wish().holds());
    }
    return peer;
  }

  void hearRem(Rem rem) {
    Peer peer = peers.computeIfAbsent(rem.from(), id -> new Peer());
    boolean isOver = rem.left().isEmpty();
    if (rem.num() > peer.seen && isOver) {
      peer.begin(rem.num(), Sections.NONE);
    }
    if (rem.num() == peer.seen) {
      peer.want = Sections.common(peer.want, rem.left());
      peer.open = Sections.common(peer.open, rem.left());
      peer.done |= isOver;
      if (isOver) {
        pending.remove(rem.from());
      }
    }
  }

  /** Defers the answer; returns whether it was already deferred. */
  boolean defer(Req req) {
    return req.equals(pending.put(req.from(), req));
  }

  /** The requests whose answer, or a part of it, is deferred, in order of arrival. */
  List<Req> pending() {
    return new ArrayList<>(pending.values());
  }

  /** Forgets a deferred request that has all consents. */
  void settle(Req req) {
    Peer peer = peers.get(req.from());
    if (peer == null || peer.hasAll(req)) {
      pending.remove(req.from());
    }
  }

  /** Number of participants that compete for all of {@code sections}. */
  int wanting(List<String> sections) {
    return (int)
        peers.values().stream()
            .filter(peer ->
                sections.stream().allMatch(each -> Sections.compete(peer.want, List.of(each))))
            .count();
  }

  @Nullable Peer find(ProcessId id) {
    return peers.get(id);
  }

  /**
   * Whether {@code id} has asked this process for all that it may hold: it asks a new process for a
   * sequence of which it holds a part already.
   */
  boolean hasAsked(ProcessId id) {
    Peer peer = peers.get(id);
    return peer != null && peer.seen > 0 && !peer.inOrder;
  }

  /** The granted part of {@code id}'s newest request that it may still hold. */
  SortedSet<String> open(ProcessId id) {
    Peer peer = peers.get(id);
    return peer == null ? Sections.NONE : peer.open;
  }

  /** Whether the grants of newest requests leave no place in {@code section} that it does not hold. */
  boolean isGiven(String section) {
    List<String> one = List.of(section);
    return peers.values().stream()
        .anyMatch(peer ->
            Sections.exclude(peer.open, one)
                || Sections.compete(Sections.without(peer.open, peer.inside), one));
  }

  void forget(Predicate<ProcessId> gone) {
    peers.keySet().removeIf(gone);
    pending.keySet().removeIf(gone);
  }

  /** The whole record: equal texts behave alike. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    peers.forEach((id, peer) ->
        text.append(' ')
            .append(id)
            .append(':')
            .append(peer.seen)
            .append(peer.granted)
            .append(peer.counted.isEmpty() ? "" : "c" + peer.counted)
            .append(peer.inOrder ? peer.want : "")
            .append(peer.done ? "d" : "")
            .append(peer.open));
    return text.append(' ').append(pending).toString();
  }
}
