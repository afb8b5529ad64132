package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.RobotId;

/**
 * One robot's vote: notes what everybody holds and wants, and consents to nothing that meets a note.
 * What it consents to is noted, on stable storage, before it says so. Pure.
 */
class TubeVoter {

  private final Participants participants;
  private final Out out;
  private final SortedMap<RobotId, Note> notes = new TreeMap<>();

  /** What a robot has said last. {@code voted}: this voter has consented to what it wants. */
  record Note(Holding holding, boolean voted) {}

  /** Where a voter's effects go. */
  interface Out {

    /** Sends, best effort. */
    void send(RobotId to, TubeMessage message);

    /** Writes the note, and sends {@code answer} once it would survive a crash. */
    void persist(RobotId about, Note note, TubeMessage answer);
  }

  TubeVoter(Participants participants, Out out) {
    this.participants = participants;
    this.out = out;
  }

  /** Remembers what was persisted before a restart. */
  void restore(RobotId about, Note note) {
    notes.put(about, note);
  }

  void asked(RobotId from, Holding holding) {
    Note before = notes.get(from);
    if (!participants.contains(from)
        || (before != null && holding.version() < before.holding().version())) {
      return;
    }
    boolean again = before != null && before.voted() && before.holding().equals(holding);
    RobotId inTheWay = again ? null : inTheWay(from, holding);
    if (inTheWay == null) {
      Note note = new Note(holding, true);
      notes.put(from, note);
      out.persist(from, note, new TubeMessage.Vote(holding.version()));
    } else {
      notes.put(from, new Note(holding.withoutWanted(), false));
      Note theirs = notes.get(inTheWay);
      Holding known = theirs == null ? Holding.NONE : theirs.holding();
      out.send(from, new TubeMessage.Refuse(holding.version(), inTheWay, known));
    }
  }

  /** Whose tubes the wanted ones meet, or who has not said where it stands; null if nobody. */
  @Nullable RobotId inTheWay(RobotId from, Holding holding) {
    if (holding.wanted().isEmpty()) {
      return null;
    }
    // The first thing that a robot asks for is the place where it stands.
    boolean moves = !holding.held().isEmpty();
    for (RobotId other : participants) {
      if (other.equals(from)) {
        continue;
      }
      List<Tube> theirs = tubesOf(other);
      if ((moves && theirs.isEmpty()) || Tube.meet(holding.wanted(), theirs)) {
        return other;
      }
    }
    return null;
  }

  /** All that {@code robot} holds or wants, as far as noted. */
  List<Tube> tubesOf(RobotId robot) {
    Note note = notes.get(robot);
    return note == null ? List.of() : note.holding().all();
  }

  /** The latest word of each robot but {@code me}. */
  SortedMap<RobotId, Holding> others(RobotId me) {
    SortedMap<RobotId, Holding> others = new TreeMap<>();
    for (Map.Entry<RobotId, Note> note : notes.entrySet()) {
      if (!note.getKey().equals(me)) {
        others.put(note.getKey(), note.getValue().holding());
      }
    }
    return others;
  }

  List<RobotId> unplaced() {
    List<RobotId> unplaced = new ArrayList<>();
    for (RobotId robot : participants) {
      if (tubesOf(robot).isEmpty()) {
        unplaced.add(robot);
      }
    }
    return unplaced;
  }
}
