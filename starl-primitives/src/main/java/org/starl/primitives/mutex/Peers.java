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

/** What one participant remembers of the others' newest requests, and what became of them. */
final class Peers {

  /** One other participant's newest request. */
  static final class Peer {
    private long seen;
    private boolean granted;
    private boolean done;
    // The part of what was granted that the other may still hold.
    private SortedSet<String> open = Sections.NONE;

    private void isNowAt(long num) {
      seen = num;
      granted = false;
      done = false;
      open = Sections.NONE;
    }

    boolean isGranted() {
      return granted;
    }
  }

  private final TreeMap<ProcessId, Peer> peers = new TreeMap<>();
  private final Map<ProcessId, Req> pending = new LinkedHashMap<>();

  /** Takes note of {@code req}; null if it is stale or withdrawn, and must never be answered. */
  @Nullable Peer hear(Req req) {
    Peer peer = peers.computeIfAbsent(req.from(), id -> new Peer());
    if (req.num() < peer.seen || (req.num() == peer.seen && peer.done)) {
      return null;
    }
    if (req.num() > peer.seen) {
      peer.isNowAt(req.num());
      pending.remove(req.from());
    }
    return peer;
  }

  void hearRem(Rem rem) {
    Peer peer = peers.computeIfAbsent(rem.from(), id -> new Peer());
    boolean isOver = rem.left().isEmpty();
    if (rem.num() > peer.seen && isOver) {
      peer.isNowAt(rem.num());
    }
    if (rem.num() == peer.seen) {
      peer.open = Sections.common(peer.open, rem.left());
      peer.done |= isOver;
      if (isOver) {
        pending.remove(rem.from());
      }
    }
  }

  void grant(Req req, Peer peer) {
    peer.granted = true;
    peer.open = req.want();
  }

  /** Its answer is kept back; returns whether it was before. */
  boolean keepBack(Req req) {
    return req.equals(pending.put(req.from(), req));
  }

  /** Takes those that are kept back no more, in the order in which they came. */
  List<Req> takePending(Predicate<Req> isFree) {
    List<Req> free = new ArrayList<>();
    for (Req req : pending.values()) {
      if (isFree.test(req)) {
        free.add(req);
      }
    }
    free.forEach(req -> pending.remove(req.from()));
    return free;
  }

  void dropPending(ProcessId from) {
    pending.remove(from);
  }

  @Nullable Peer find(ProcessId id) {
    return peers.get(id);
  }

  /** Whether {@code id} has ever asked this participant, as far as that is remembered. */
  boolean hasAsked(ProcessId id) {
    Peer peer = peers.get(id);
    return peer != null && peer.seen > 0;
  }

  /** The part of {@code id}'s newest request that was granted and that it may still hold. */
  SortedSet<String> open(ProcessId id) {
    Peer peer = peers.get(id);
    return peer == null ? Sections.NONE : peer.open;
  }

  void forget(Predicate<ProcessId> gone) {
    peers.keySet().removeIf(gone);
    pending.keySet().removeIf(gone);
  }

  /** Everything that is remembered: equal texts behave alike. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    peers.forEach((id, peer) ->
        text.append(' ')
            .append(id)
            .append(':')
            .append(peer.seen)
            .append(peer.granted ? "g" : "")
            .append(peer.done ? "d" : "")
            .append(peer.open));
    return text.append(' ').append(pending).toString();
  }
}
