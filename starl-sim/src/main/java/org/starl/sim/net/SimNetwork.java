package org.starl.sim.net;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.random.Rng;
import org.starl.sim.kernel.Kernel;
import org.starl.sim.kernel.SimStrand;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

/**
 * The radio network of all robots of a run. Robots come and go with {@link #attach} and {@link #detach};
 * rules with {@link #install}. Used by one kernel at a time.
 */
public final class SimNetwork {

  private static final long LOST = CopyWatch.LOST;

  /** The delay of a copy that draws its own. */
  private static final long OWN = -2;

  private final Kernel kernel;

  private final TraceSink trace;
  private final Rng root;
  private final StationTable stations = new StationTable();
  private final List<SimRadio> attached = new ArrayList<>();
  private final List<LinkRule> rules = new ArrayList<>();
  private final List<NetworkTap> taps = new ArrayList<>();
  private @Nullable CopyWatch watch;
  // By number; null while the robot has no radio.
  private final List<@Nullable SimRadio> byNumber = new ArrayList<>();
  private @Nullable Coverage coverage;
  private final Hearers hearers = new Hearers();
  private final DeliveryPool pool = new DeliveryPool();
  private Latency latency = new Latency.Constant(0);
  private Loss loss = Loss.NONE;
  private long sent;
  private long sentBytes;
  private long delivered;
  private long lost;

  /**
   * @param kernel provides the run's true time and runs deliveries
   * @param rng the run's generator; the network forks it by robots' names
   */
  public SimNetwork(Kernel kernel, TraceSink trace, Rng rng) {
    this.kernel = kernel;
    this.trace = trace;
    this.root = rng;
  }

  /** Sets delay and loss of copies that no rule decides. */
  public void base(Latency newLatency, Loss newLoss) {
    latency = newLatency;
    loss = newLoss;
  }

  /**
   * Creates a radio for {@code id}, which receives on {@code strand}.
   *
   * @throws IllegalStateException if {@code id} already has a radio
   */
  public Radio attach(RobotId id, SimStrand strand) {
    return attach(id, strand, null);
  }

  /**
   * Creates a radio for {@code id}, which receives on {@code strand} through {@code gate}, if any.
   *
   * @throws IllegalStateException if {@code id} already has a radio
   */
  public Radio attach(RobotId id, SimStrand strand, @Nullable ArrivalGate gate) {
    int known = stations.slot(id);
    int slot = known == StationTable.NONE ? stations.add(id, newKey(id)) : known;
    if (stations.radio(slot) != null) {
      throw new IllegalStateException(id + " already has a radio");
    }
    SimRadio radio =
        new SimRadio(
            this,
            id,
            stations.number(slot),
            stations.key(slot),
            stations.datagrams(slot),
            strand,
            gate);
    stations.attach(slot, radio, strand);
    attached.add(radio);
    if (radio.number() == byNumber.size()) {
      byNumber.add(radio);
    } else {
      byNumber.set(radio.number(), radio);
    }
    return radio;
  }

  /**
   * The number of robots that got their first radio before this one: the same in all its
   * incarnations.
   */
  public int number(RobotId id) {
    int number = stations.number(stations.slot(id));
    if (number == StationTable.NONE) {
      throw new IllegalArgumentException(id + " never had a radio");
    }
    return number;
  }

  /**
   * Limits the radios. A broadcast is then one event: it has one delay, reaches the robots that
   * {@code newCoverage} finds in the order of their numbers, and the others do not count as losses.
   */
  public void limit(Coverage newCoverage) {
    coverage = newCoverage;
  }

  /**
   * Removes the radio of {@code id}: it sends no more datagrams, and datagrams in flight to it are
   * lost.
   */
  public void detach(RobotId id) {
    int slot = stations.slot(id);
    SimRadio radio = stations.radio(slot);
    if (radio != null) {
      radio.close();
      attached.remove(radio);
      byNumber.set(radio.number(), null);
      stations.detach(slot, radio.datagrams());
    }
  }

  /** Installs {@code rule} before the installed ones, until its handle removes it. */
  public LinkRule.Handle install(LinkRule rule) {
    // A wrapper, so that a rule installed twice can be removed once.
    LinkRule own = copy -> rule.judge(copy);
    rules.add(0, own);
    return () -> rules.remove(own);
  }

  /** Adds a listener to all datagrams sent from now on. */
  public NetworkTap.Handle listen(NetworkTap tap) {
    // A wrapper, so that a tap that listens twice can stop once.
    NetworkTap own = (from, buffer, length) -> tap.sent(from, buffer, length);
    taps.add(own);
    return () -> taps.remove(own);
  }

  /** Sets the watch, if any, which is told of each copy that a robot sends from now on. */
  public void watch(@Nullable CopyWatch newWatch) {
    watch = newWatch;
  }

  /**
   * Delivers these bytes to {@code to} now, as an attacker would: no robot sends them. No rule and
   * no loss applies. Does nothing if {@code to} has no radio.
   */
  public void inject(RobotId to, byte[] datagram) {
    SimRadio radio = stations.radio(stations.slot(to));
    if (radio != null) {
      Packet packet = pool.packet(datagram, datagram.length);
      kernel.schedule(
          kernel.nowNs(), radio.strand(), pool.delivery(DeliveryPool.NO_SENDER, radio, packet));
      packet.release();
    }
  }

  public NetStatistics statistics() {
    return new NetStatistics(sent, sentBytes, delivered, lost);
  }

  void send(SimRadio from, RobotId to, byte[] buffer, int length) {
    long datagram = countSent(from, buffer, length);
    Packet packet = pool.packet(buffer, length);
    String obstacle = coverage == null ? "" : obstacle(coverage, from, to);
    if (obstacle.isEmpty()) {
      transmit(from, to, packet, datagram, OWN);
    } else {
      dropped(from.id(), to, obstacle);
    }
    packet.release();
  }

  void broadcast(SimRadio from, byte[] buffer, int length) {
    long datagram = countSent(from, buffer, length);
    Packet packet = pool.packet(buffer, length);
    if (coverage == null) {
      for (int i = 0; i < attached.size(); i++) {
        SimRadio to = attached.get(i);
        if (to != from) {
          transmit(from, to.id(), packet, datagram, OWN);
        }
      }
    } else {
      hearers.clear();
      coverage.find(from.number(), hearers);
      hearers.sort();
      broadcastToHearers(from, packet, datagram);
    }
    packet.release();
  }

  private String obstacle(Coverage limits, SimRadio from, RobotId to) {
    int number = stations.number(stations.slot(to));
    return number == StationTable.NONE ? "" : limits.obstacle(from.number(), number);
  }

  private void broadcastToHearers(SimRadio from, Packet packet, long datagram) {
    // All hear it at once: the delay is that of the sender.
    long delayNs =
        latency.isConstant()
            ? ((Latency.Constant) latency).ns()
            : latency.drawNs(root.withSeed(from.copySeed(from.key(), datagram)));
    boolean isShared = rules.isEmpty() && watch == null;
    BroadcastDelivery delivery = pool.broadcast(kernel, from.id(), packet);
    for (int i = 0; i < hearers.size(); i++) {
      SimRadio to = byNumber.get(hearers.number(i));
      if (to == null || to == from) {
        continue;
      }
      if (!isShared) {
        transmit(from, to.id(), packet, datagram, delayNs);
      } else if (isLost(from, to, datagram)) {
        dropped(from.id(), to.id(), "loss");
      } else {
        delivery.add(to);
      }
    }
    if (delivery.isEmpty()) {
      delivery.end();
    } else {
      kernel.schedule(kernel.nowNs() + delayNs, delivery);
    }
  }

  private boolean isLost(SimRadio from, SimRadio to, long datagram) {
    return loss.isCertain()
        ? loss.probability() > 0
        : loss.strikes(root.withSeed(from.copySeed(to.key(), datagram)));
  }

  void delivered() {
    delivered++;
  }

  void dropped(RobotId from, RobotId to, String why) {
    lost++;
    if (trace.isOn()) {
      trace.record(new TraceEvent.Dropped(kernel.nowNs(), to, from.name(), why));
    }
  }

  private long countSent(SimRadio from, byte[] buffer, int length) {
    sent++;
    sentBytes += length;
    for (int i = 0; i < taps.size(); i++) {
      taps.get(i).sent(from.id(), buffer, length);
    }
    return from.nextDatagram();
  }

  /**
   * @param sharedNs the delay that all copies of a broadcast have, or {@link #OWN}
   */
  private void transmit(SimRadio from, RobotId to, Packet packet, long datagram, long sharedNs) {
    if (!rules.isEmpty() || watch != null) {
      transmitByRules(from, to, packet, datagram, sharedNs);
      return;
    }
    long delayNs = baseDelayNs(from, to, datagram, sharedNs);
    if (delayNs == LOST) {
      dropped(from.id(), to, "loss");
    } else {
      deliver(from, to, packet, delayNs);
    }
  }

  private void transmitByRules(
      SimRadio from, RobotId to, Packet packet, long datagram, long sharedNs) {
    // Rules have their own generator: a rule that draws and passes does not change the base delay.
    Rng rng = root.withSeed(~from.copySeed(key(to), datagram));
    Transmission copy = new Transmission(from.id(), to, kernel.nowNs(), datagram, rng);
    long laterNs = 0;
    long exactNs = LOST;
    List<Long> againNs = new ArrayList<>(0);
    for (int i = 0; i < rules.size(); i++) {
      switch (rules.get(i).judge(copy)) {
        case Verdict.Pass pass -> {}
        case Verdict.Later later -> laterNs += later.extraNs();
        case Verdict.Again again -> againNs.add(again.afterNs());
        // The rule that was installed last decides.
        case Verdict.Exactly exactly -> exactNs = exactNs == LOST ? exactly.delayNs() : exactNs;
        case Verdict.Drop drop -> {
          tellWatch(copy, LOST);
          dropped(from.id(), to, drop.why());
          return;
        }
      }
    }
    long delayNs = exactNs == LOST ? baseDelayNs(from, to, datagram, sharedNs) : exactNs;
    if (delayNs == LOST) {
      tellWatch(copy, LOST);
      dropped(from.id(), to, "loss");
    } else {
      tellWatch(copy, delayNs + laterNs);
      deliver(from, to, packet, delayNs + laterNs, againNs);
    }
  }

  private void tellWatch(Transmission copy, long delayNs) {
    if (watch != null) {
      watch.sent(copy, delayNs);
    }
  }

  private void deliver(SimRadio from, RobotId to, Packet packet, long delayNs, List<Long> againNs) {
    deliver(from, to, packet, delayNs);
    for (long afterNs : againNs) {
      deliver(from, to, packet, delayNs + afterNs);
    }
  }

  /** The delay in ns, or {@link #LOST}. */
  private long baseDelayNs(SimRadio from, RobotId to, long datagram, long sharedNs) {
    if (loss.isCertain() && latency.isConstant()) {
      return loss.probability() > 0 ? LOST : ((Latency.Constant) latency).ns();
    }
    Rng rng = root.withSeed(from.copySeed(key(to), datagram));
    if (loss.strikes(rng)) {
      return LOST;
    }
    return sharedNs == OWN ? latency.drawNs(rng) : sharedNs;
  }

  private void deliver(SimRadio from, RobotId to, Packet packet, long delayNs) {
    int slot = stations.slot(to);
    SimRadio radio = stations.radio(slot);
    SimStrand strand = stations.strand(slot);
    if (radio == null || strand == null) {
      dropped(from.id(), to, "no-such-robot");
    } else {
      kernel.schedule(kernel.nowNs() + delayNs, strand, pool.delivery(from.id(), radio, packet));
    }
  }

  private long key(RobotId robot) {
    int slot = stations.slot(robot);
    return slot == StationTable.NONE ? newKey(robot) : stations.key(slot);
  }

  /** The key of the robot's random numbers: a function of its name and the run's seed. */
  private long newKey(RobotId id) {
    return root.fork(id.name() + "/radio").nextLong();
  }
}
