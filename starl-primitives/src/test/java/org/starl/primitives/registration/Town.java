package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.chaos.FoulNetwork;
import org.starl.random.Rng;
import org.starl.spec.Monitor;
import org.starl.trace.Instance;

/** Robots of one registration, over a foul network. */
final class Town extends FoulNetwork {

  static final Instance SOURCE = Instance.of(RegistrationFact.PRIMITIVE, "town");

  /** Makes a robot's protocol; mutants make another one. */
  interface Maker {
    RegistrationProtocol make(
        RobotId self,
        Participants acceptors,
        RegistrationSettings settings,
        Rng rng,
        SynodLink link,
        RegistrationPort port,
        long nowNs);
  }

  final Participants acceptors;
  final Map<RobotId, TownRobot> robots = new TreeMap<>();

  RegistrationSettings settings = RegistrationSettings.DEFAULT;
  Maker maker =
      (self, who, set, r, link, port, now) ->
          new RegistrationProtocol(self, who, set, r, link, port, now);

  /** What becomes of a message on its way. */
  UnaryOperator<SynodMessage> tamper = UnaryOperator.identity();

  boolean acceptorsForget;

  /** Whether writes are said to be stable before they are. */
  boolean flushesLie;

  /** Whether reliable messages are dropped, as if the sender went away at once. */
  boolean newsIsLost;

  /** Whether all robots number their ballots alike. */
  boolean ballotsCollide;

  Town(long seed, int size, int acceptorCount, Monitor spec) {
    super(seed, spec, new RegistrationConformance());
    List<RobotId> names = new ArrayList<>();
    for (int i = 0; i < size; i++) {
      names.add(new RobotId("bot" + i));
    }
    acceptors = Participants.of(names.subList(0, acceptorCount));
    for (RobotId name : names) {
      robots.put(name, new TownRobot(this, name));
    }
  }

  void startAll() {
    robots.values().forEach(TownRobot::start);
  }

  TownRobot robot(int index) {
    return new ArrayList<>(robots.values()).get(index);
  }

  @Override
  protected int indexOf(RobotId name) {
    return List.copyOf(robots.keySet()).indexOf(name);
  }
}
