package org.starl.primitives.specimen;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * A mutex on sets after Ricart and Agrawala as a later release of the original StarL had it, with two
 * bugs. A request's time is its robot's place in the list, for ever, so that a late request comes
 * before one that has its consent already. And who has replied at once keeps the request all the
 * same, and replies again when it leaves, and no reply says which request it is for, so that a second
 * reply counts for the next request.
 */
final class SetMutex extends Contender {

  /** Which bugs are in it: those two, and some that the original did not have. */
  enum Bug {
    LIST_INDEX,
    DOUBLE_REPLIES,
    /** Only the next ones in the list are asked. */
    ASKS_NEIGHBOURS,
    /** Who is on no list is let in as well. */
    LETS_STRANGERS_IN,
    /** Who has all answers but one enters. */
    ENTERS_EARLY
  }

  private final Set<Bug> bugs;
  private final boolean tellsGrants;
  private final Endpoint<Word> endpoint;
  private final SortedSet<RobotId> missing = new TreeSet<>();
  private final SortedMap<RobotId, Long> kept = new TreeMap<>();
  private SortedSet<String> wanted = sections();
  private long number;
  private long clock;
  private long time;

  /**
   * @param tellsGrants whether it says in the trace to whom it consents
   */
  SetMutex(GlobalVarHolder gvh, Set<Bug> bugs, boolean tellsGrants) {
    super(gvh);
    this.bugs = bugs;
    this.tellsGrants = tellsGrants;
    endpoint = gvh.comms.open(new Channel<>("mutex", XID, Word.CODEC), this::received);
  }

  @Override
  SortedSet<String> draw(Rng draws) {
    return draws.nextBoolean(0.5) ? sections("A") : sections("A", "B");
  }

  @Override
  List<RobotId> listed() {
    return bugs.contains(Bug.LETS_STRANGERS_IN) ? all.subList(0, all.size() - 1) : all;
  }

  @Override
  List<RobotId> asked() {
    int index = all.indexOf(me);
    return bugs.contains(Bug.ASKS_NEIGHBOURS)
        ? all.subList(Math.max(0, index - 1), Math.min(all.size(), index + 2))
        : all;
  }

  @Override
  long time() {
    return bugs.contains(Bug.LIST_INDEX) ? 0 : clock + 1;
  }

  @Override
  void request(SortedSet<String> sections) {
    number++;
    time = time();
    clock++;
    wanted = sections;
    missing.addAll(asked());
    missing.remove(me);
    List<String> names = new ArrayList<>(List.of(Long.toString(time)));
    names.addAll(sections);
    for (RobotId other : missing) {
      endpoint.sendReliably(other, new Word("REQUEST", number, names));
    }
  }

  @Override
  boolean isIn() {
    return missing.size() <= (bugs.contains(Bug.ENTERS_EARLY) ? 1 : 0);
  }

  @Override
  void exit() {
    wanted = sections();
    kept.forEach(this::reply);
    kept.clear();
  }

  private void reply(RobotId to, long itsNumber) {
    if (tellsGrants) {
      tellGrant(to, itsNumber);
    }
    endpoint.sendReliably(to, new Word("REPLY", itsNumber));
  }

  private void received(RobotId from, Word word) {
    if (word.kind().equals("REPLY")) {
      if (bugs.contains(Bug.DOUBLE_REPLIES) || word.number() == number) {
        missing.remove(from);
      }
      return;
    }
    long itsTime = Long.parseLong(word.names().get(0));
    clock = Math.max(clock, itsTime);
    boolean meets = !Collections.disjoint(wanted, word.names());
    if (meets && (isIn() || isBefore(from, itsTime))) {
      kept.put(from, word.number());
      return;
    }
    reply(from, word.number());
    if (bugs.contains(Bug.DOUBLE_REPLIES)) {
      kept.put(from, word.number());
    }
  }

  /** Whether this robot's request comes first; equal times are told apart by the list. */
  private boolean isBefore(RobotId other, long itsTime) {
    return time < itsTime || (time == itsTime && all.indexOf(me) < all.indexOf(other));
  }
}
