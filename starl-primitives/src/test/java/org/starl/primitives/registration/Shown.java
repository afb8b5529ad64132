package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.List;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.AgreementFact;
import org.starl.primitives.agreement.Ballot;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Short;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/** Events of a registration written briefly, for tests. */
public final class Shown {

  static final Instance HERE = Instance.of(RegistrationFact.PRIMITIVE, "here");

  private Shown() {}

  /** An action of {@code robot} with an id: {@code do_register a}. */
  public static TraceEvent acts(long atNs, String robot, String verb, String id) {
    ProcessId i = ProcessId.parse(id);
    RegistrationAction action =
        switch (verb) {
          case "do_register" -> new RegistrationAction.do_register(i);
          case "unregister" -> new RegistrationAction.unregister(i);
          case "give_up" -> new RegistrationAction.give_up(i);
          default -> throw new IllegalArgumentException(verb);
        };
    return Action.of(atNs, new RobotId(robot), HERE, RegistrationFact.ACTIONS, action);
  }

  static TraceEvent confines(long atNs, String robot, String who, String sections, String fencers) {
    Confinement confinement = Short.confinement(who, sections, fencers);
    return Action.of(atNs, new RobotId(robot), HERE, RegistrationFact.CONFINE, confinement);
  }

  static TraceEvent acceptors(long atNs, String robot, String... robots) {
    List<RobotId> names = new ArrayList<>();
    for (String name : robots) {
      names.add(new RobotId(name));
    }
    AgreementFact.Acceptors acceptors = new AgreementFact.Acceptors(names);
    return Action.of(atNs, new RobotId(robot), HERE, AgreementFact.ACCEPTORS, acceptors);
  }

  /** A view as its {@code toString}. */
  public static TraceEvent sees(long atNs, String robot, String view) {
    return new Variable(atNs, new RobotId(robot), HERE, RegistrationFact.VIEW, Short.view(view));
  }

  /** A list as its {@code toString}, {@code 3:[a, b]}, or {@code null}. */
  public static TraceEvent shows(long atNs, String robot, String list) {
    RList shown = RList.UNKNOWN;
    if (!list.equals("null")) {
      String[] parts = list.split("[:\\[\\], ]+");
      List<RobotId> robots = new ArrayList<>();
      for (String name : List.of(parts).subList(1, parts.length)) {
        robots.add(new RobotId(name));
      }
      shown = new RList.Agreed(Participants.of(robots), Long.parseLong(parts[0]));
    }
    return new Variable(atNs, new RobotId(robot), HERE, RegistrationFact.R_LIST, shown);
  }

  /** The robot hears a vote of {@code from} for this view. */
  static TraceEvent hearsVote(long atNs, String robot, String from, long number) {
    SynodMessage vote = new SynodMessage.Accepted(number, new Ballot(1, ProcessId.parse(robot)));
    return new Delivered(
        atNs, new RobotId(robot), new RobotId(from), HERE, 1, SynodMessage.SHAPE, vote);
  }

  /** The robot hears {@code from} propose this view. */
  static TraceEvent hearsProposal(long atNs, String robot, String from, long number) {
    SynodMessage prepare =
        new SynodMessage.Prepare(number, new Ballot(1, ProcessId.parse(from)), Value.EMPTY);
    return new Delivered(
        atNs, new RobotId(robot), new RobotId(from), HERE, 1, SynodMessage.SHAPE, prepare);
  }

  /** The robot tells another one that this view is decided. */
  static TraceEvent tells(long atNs, String robot, String to, long number) {
    return sends(atNs, robot, to, new SynodMessage.Decided(number, Value.EMPTY));
  }

  static TraceEvent sends(long atNs, String robot, String to, SynodMessage message) {
    return new Sent(atNs, new RobotId(robot), to, HERE, 1, 1, SynodMessage.SHAPE, message);
  }

  /** The robot proposes this view. */
  static TraceEvent proposes(long atNs, String robot, long number) {
    Ballot ballot = new Ballot(1, ProcessId.parse(robot));
    return sends(atNs, robot, robot, new SynodMessage.Prepare(number, ballot, Value.EMPTY));
  }

  /** The robot hears of a decided view. */
  static TraceEvent hearsView(long atNs, String robot, String from, long number) {
    return new Delivered(
        atNs,
        new RobotId(robot),
        new RobotId(from),
        HERE,
        1,
        SynodMessage.SHAPE,
        new SynodMessage.Decided(number, Value.EMPTY));
  }

  /** The robot may end. */
  static TraceEvent unregistered(long atNs, String robot) {
    return new Variable(atNs, new RobotId(robot), HERE, RegistrationFact.UNREGISTERED, true);
  }

  /** Whether the latest call has failed. */
  public static TraceEvent failed(long atNs, String robot) {
    return failed(atNs, robot, true);
  }

  static TraceEvent failed(long atNs, String robot, boolean has) {
    return new Variable(atNs, new RobotId(robot), HERE, RegistrationFact.FAILED, has);
  }
}
