package org.starl.primitives.paths;

import static org.starl.shape.Shapes.part;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * The votes of one robot: notes the tubes of all robots, and consents to a wanted tube only if it
 * meets no noted one. It stores each consent on stable storage before it sends it. Pure.
 */
class TubeVoter {

  private final Participants participants;
  private final Out out;
  private final SortedMap<RobotId, Note> notes = new TreeMap<>();

  /** The latest tubes of a robot. {@code voted}: this voter has consented to the wanted tube. */
  record Note(Holding holding, boolean voted) {

    /** Its shape on stable storage. */
    static final Shape<Note> SHAPE =
        Shapes.of(
            Note.class,
            part("voted", Shapes.BOOL, Note::voted),
            part("holding", Holding.SHAPE, Note::holding),
            (voted, holding) -> new Note(holding, voted));
  }

  /** The effects of a voter. */
  interface Out {

    /** Sends, best effort. */
    void send(RobotId to, TubeMessage message);

    /** Stores the note, and then sends {@code answer}. */
    void persist(RobotId about, Note note, TubeMessage answer);
  }

  TubeVoter(Participants participants, Out out) {
    this.participants = participants;
    this.out = out;
  }

  /** Restores a note that was stored before a restart. */
  void restore(RobotId about, Note note) {
    notes.put(about, note);
  }

  void asked(RobotId from, Holding holding) {
    Note before = notes.get(from);
    if (!participants.contains(from) || holding.version() < version(from)) {
      return;
    }
    boolean again = before != null && before.voted() && before.holding().equals(holding);
    RobotId conflicting = again ? null : conflicting(from, holding);
    if (conflicting == null) {
      Note note = new Note(holding, true);
      notes.put(from, note);
      out.persist(from, note, new TubeMessage.Vote(holding.version()));
    } else {
      notes.put(from, new Note(holding.withoutWanted(), false));
      Note theirs = notes.get(conflicting);
      Holding known = theirs == null ? Holding.NONE : theirs.holding();
      out.send(from, new TubeMessage.Refuse(holding.version(), conflicting, known));
    }
  }

  /** A robot whose tubes meet the wanted ones, or whose place is not known; null if none. */
  @Nullable RobotId conflicting(RobotId from, Holding holding) {
    if (holding.wanted().isEmpty()) {
      return null;
    }
    // A robot's first request is for the disc at its place.
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

  /** The tubes that {@code robot} holds or wants, as noted. */
  List<Tube> tubesOf(RobotId robot) {
    Note note = notes.get(robot);
    return note == null ? List.of() : note.holding().all();
  }

  /** The latest holding of each robot except {@code me}. */
  SortedMap<RobotId, Holding> others(RobotId me) {
    SortedMap<RobotId, Holding> others = new TreeMap<>();
    notes.forEach((robot, note) -> others.put(robot, note.holding()));
    others.remove(me);
    return others;
  }

  /** The latest version that it has heard of, 0 for none. */
  long version(RobotId robot) {
    Note note = notes.get(robot);
    return note == null ? 0 : note.holding().version();
  }

  /** All that decides its answers. */
  String state() {
    return notes.toString();
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
