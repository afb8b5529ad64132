package org.starl.primitives.specimen;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * A mutex of one section by a token that is handed on together with the list of those who wait.
 * Whoever hands it on tells everybody who owns it now, three times since datagrams get lost, and
 * whoever hears this believes it, as the original StarL's token mutex did. So a word that comes late
 * makes an owner of somebody who has handed the token on since.
 */
final class TokenMutex extends Contender {

  private static final int TIMES_TOLD = 3;
  private static final int TICKS_BETWEEN = 6;

  private final boolean isMended;
  private final Endpoint<Word> endpoint;
  private final List<String> waiting = new ArrayList<>();
  private RobotId owner;
  private long handovers;
  private boolean wants;
  private int toTell;
  private int ticks;

  /**
   * @param isMended whether a word about the owner counts only if it is newer than what is known
   */
  TokenMutex(GlobalVarHolder gvh, boolean isMended) {
    super(gvh);
    this.isMended = isMended;
    owner = all.get(0);
    endpoint = gvh.comms.open(new Channel<>("mutex", XID, Word.CODEC), this::received);
  }

  @Override
  SortedSet<String> draw(Rng draws) {
    return sections("A");
  }

  @Override
  long time() {
    return handovers;
  }

  @Override
  void request(SortedSet<String> sections) {
    wants = true;
  }

  @Override
  boolean isIn() {
    return owner.equals(me);
  }

  @Override
  void exit() {
    wants = false;
    handOn();
  }

  @Override
  void tick() {
    ticks++;
    if (ticks % TICKS_BETWEEN != 0) {
      return;
    }
    if (toTell > 0) {
      toTell--;
      endpoint.broadcast(new Word("OWNER", handovers, owner.name()));
    }
    if (wants && !isIn()) {
      endpoint.send(owner, new Word("REQUEST", 0, me.name()));
    }
  }

  private void handOn() {
    if (!isIn() || wants || waiting.isEmpty()) {
      return;
    }
    owner = new RobotId(waiting.remove(0));
    handovers++;
    endpoint.sendReliably(owner, new Word("TOKEN", handovers, List.copyOf(waiting)));
    waiting.clear();
    toTell = TIMES_TOLD;
  }

  private void received(RobotId from, Word word) {
    switch (word.kind()) {
      case "REQUEST" -> {
        String who = word.names().get(0);
        if (!isIn()) {
          endpoint.send(owner, word);
        } else if (!waiting.contains(who) && !who.equals(me.name())) {
          waiting.add(who);
          handOn();
        }
      }
      case "TOKEN" -> {
        owner = me;
        handovers = word.number();
        toTell = 0;
        waiting.addAll(word.names());
        waiting.remove(me.name());
        handOn();
      }
      default -> {
        if (!isMended || (word.number() > handovers && !word.names().get(0).equals(me.name()))) {
          owner = new RobotId(word.names().get(0));
          handovers = word.number();
          toTell = 0;
        }
      }
    }
  }
}
