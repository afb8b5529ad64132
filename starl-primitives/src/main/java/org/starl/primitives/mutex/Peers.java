package org.starl.primitives.mutex;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;
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
    private boolean granted;
    private boolean done;
    // The granted sections that the other may still hold.
    private SortedSet<String> open = Sections.NONE;

    private void begin(long num) {
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

  /** Records {@code req}; null if it is stale or withdrawn, and must not be answered. */
  @Nullable Peer hear(Req req) {
    Peer peer = peers.computeIfAbsent(req.from(), id -> new Peer());
    if (req.num() < peer.seen || (req.num() == peer.seen && peer.done)) {
      return null;
    }
    if (req.num() > peer.seen) {
      peer.begin(req.num());
      pending.remove(req.from());
    }
    return peer;
  }

  void hearRem(Rem rem) {
    Peer peer = peers.computeIfAbsent(rem.from(), id -> new Peer());
    boolean isOver = rem.left().isEmpty();
    if (rem.num() > peer.seen && isOver) {
      peer.begin(rem.num());
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

  /** Defers the answer; returns whether it was already deferred. */
  boolean defer(Req req) {
    return req.equals(pending.put(req.from(), req));
  }

  /** Removes and returns the deferred requests that are free now, in order of arrival. */
  List<Req> takePending(Predicate<Req> isFree) {
    List<Req> free = pending.values().stream().filter(isFree).collect(Collectors.toList());
    free.forEach(req -> pending.remove(req.from()));
    return free;
  }

  @Nullable Peer find(ProcessId id) {
    return peers.get(id);
  }

  /** Whether a request of {@code id} is recorded. */
  boolean hasAsked(ProcessId id) {
    Peer peer = peers.get(id);
    return peer != null && peer.seen > 0;
  }

  /** The granted part of {@code id}'s newest request that it may still hold. */
  SortedSet<String> open(ProcessId id) {
    Peer peer = peers.get(id);
    return peer == null ? Sections.NONE : peer.open;
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
            .append(peer.granted ? "g" : "")
            .append(peer.done ? "d" : "")
            .append(peer.open));
    return text.append(' ').append(pending).toString();
  }
}
