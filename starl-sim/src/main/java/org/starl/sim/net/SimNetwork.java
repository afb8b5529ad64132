package org.starl.sim.net;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.RobotId;
import org.starl.platform.Clock;
import org.starl.platform.Radio;
import org.starl.platform.TraceSink;
import org.starl.random.Rng;
import org.starl.trace.TraceEvent;

/**
 * The air between all robots of a run. Robots come and go with {@link #attach} and {@link #detach};
 * rules with {@link #install}. Used by one kernel at a time.
 */
public final class SimNetwork {

  /** Where injected datagrams come from, as far as the trace goes. */
  private static final RobotId NOBODY = new RobotId("nobody");

  private static final Inbox NOWHERE = (atNs, piece) -> {};

  private final Clock clock;
  private final TraceSink trace;
  private final Rng root;
  private final StationTable stations = new StationTable();
  private final List<SimRadio> attached = new ArrayList<>();
  private final List<Installed> rules = new ArrayList<>();
  private final List<Tap> taps = new ArrayList<>();
  private final DeliveryPool pool = new DeliveryPool(this);
  private Latency latency = new Latency.Constant(0);
  private Loss loss = Loss.NONE;
  private LinkChoice choice = LinkChoice.seeded();
  private boolean seeded = true;
  private @Nullable Audience audience;
  private long sent;
  private long sentBytes;
  private long delivered;
  private long lost;

  /**
   * @param clock the run's true time
   * @param rng the run's generator; the network forks it by robots' names
   */
  public SimNetwork(Clock clock, TraceSink trace, Rng rng) {
    this.clock = clock;
    this.trace = trace;
    this.root = rng;
  }

  /** From now on, what no rule decides takes so long and is lost so often. */
  public void base(Latency newLatency, Loss newLoss) {
    latency = newLatency;
    loss = newLoss;
  }

  /** Who makes the choices that no rule made; the seed unless set. */
  public void choice(LinkChoice newChoice) {
    choice = newChoice;
    seeded = false;
  }

  /** Who can hear whose broadcasts; everyone unless set. */
  public void audience(Audience newAudience) {
    audience = newAudience;
  }

  /**
   * Gives {@code id} a radio; what it receives runs through {@code inbox}, its strand.
   *
   * @throws IllegalStateException if it has one already
   */
  public Radio attach(RobotId id, Inbox inbox) {
    Station station = stations.find(id);
    if (station == null) {
      station = newStation(id);
      stations.add(station);
    }
    if (station.radio != null) {
      throw new IllegalStateException(id + " has a radio already");
    }
    SimRadio radio = new SimRadio(this, id, station);
    station.radio = radio;
    station.inbox = inbox;
    attached.add(radio);
    return radio;
  }

  /** Takes {@code id}'s radio off the air: it sends nothing more, what is under way to it is lost. */
  public void detach(RobotId id) {
    Station station = stations.find(id);
    if (station != null && station.radio != null) {
      station.radio.close();
      station.datagrams = station.radio.datagrams();
      attached.remove(station.radio);
      station.radio = null;
      station.inbox = NOWHERE;
    }
  }

  /** Puts {@code rule} before those that are installed, until its handle takes it out. */
  public LinkRule.Handle install(LinkRule rule) {
    Installed installed = new Installed(rule);
    rules.add(0, installed);
    return () -> rules.remove(installed);
  }

  /** Lets somebody listen to all that is sent from now on. */
  public Tap.Handle listen(Tap tap) {
    // So that one tap that listens twice can stop once.
    Tap own = (from, buffer, length) -> tap.sent(from, buffer, length);
    taps.add(own);
    return () -> taps.remove(own);
  }

  /**
   * Lets {@code to} receive these bytes now, whoever they say they are from: no robot sent them, no
   * rule and no loss befalls them. Nothing happens if {@code to} is not on the air.
   */
  public void inject(RobotId to, byte[] datagram) {
    Station station = stations.find(to);
    if (station != null && station.radio != null) {
      SimRadio radio = station.radio;
      Packet packet = pool.packet(datagram, datagram.length);
      station.inbox.schedule(clock.nowNs(), pool.delivery(NOBODY, radio, packet));
      packet.release();
    }
  }

  public NetStatistics statistics() {
    return new NetStatistics(sent, sentBytes, delivered, lost);
  }

  void send(SimRadio from, RobotId to, byte[] buffer, int length) {
    long datagram = countSent(from, buffer, length);
    Packet packet = pool.packet(buffer, length);
    transmit(from, station(to), packet, datagram);
    packet.release();
  }

  void broadcast(SimRadio from, byte[] buffer, int length) {
    long datagram = countSent(from, buffer, length);
    Packet packet = pool.packet(buffer, length);
    if (audience == null) {
      for (int i = 0; i < attached.size(); i++) {
        SimRadio to = attached.get(i);
        if (to != from) {
          transmit(from, to.station(), packet, datagram);
        }
      }
    } else {
      Consumer<RobotId> toHearer =
          to -> {
            if (!to.equals(from.id())) {
              transmit(from, station(to), packet, datagram);
            }
          };
      audience.forEachHearer(from.id(), toHearer);
    }
    packet.release();
  }

  void delivered() {
    delivered++;
  }

  void dropped(RobotId from, RobotId to, String why) {
    lost++;
    if (trace.isOn()) {
      trace.record(new TraceEvent.Dropped(clock.nowNs(), to, from.name(), why));
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

  private void transmit(SimRadio from, Station to, Packet packet, long datagram) {
    if (!rules.isEmpty()) {
      transmitByRules(from, to, packet, datagram);
      return;
    }
    long delayNs = baseDelayNs(from, to, packet, datagram);
    if (delayNs == LinkChoice.LOST) {
      dropped(from.id(), to.id, "loss");
    } else {
      deliver(from, to, packet, delayNs);
    }
  }

  private void transmitByRules(SimRadio from, Station to, Packet packet, long datagram) {
    // Rules draw from a generator of their own: one that draws and passes changes no base delay.
    Rng rng = new Rng(~from.copySeed(to, datagram));
    Transmission copy =
        new Transmission(from.id(), to.id, clock.nowNs(), datagram, packet.length(), rng);
    long laterNs = 0;
    List<Long> againNs = new ArrayList<>(0);
    for (int i = 0; i < rules.size(); i++) {
      switch (rules.get(i).rule.judge(copy)) {
        case Verdict.Pass pass -> {}
        case Verdict.Later later -> laterNs += later.extraNs();
        case Verdict.Again again -> againNs.add(again.afterNs());
        case Verdict.Drop drop -> {
          dropped(from.id(), to.id, drop.why());
          return;
        }
        case Verdict.Deliver deliver -> {
          for (int k = 0; k < deliver.copies(); k++) {
            deliver(from, to, packet, deliver.delayNs(k) + laterNs, againNs);
          }
          return;
        }
      }
    }
    long delayNs = baseDelayNs(from, to, packet, datagram);
    if (delayNs == LinkChoice.LOST) {
      dropped(from.id(), to.id, "loss");
    } else {
      deliver(from, to, packet, delayNs + laterNs, againNs);
    }
  }

  private void deliver(SimRadio from, Station to, Packet packet, long delayNs, List<Long> againNs) {
    deliver(from, to, packet, delayNs);
    for (long afterNs : againNs) {
      deliver(from, to, packet, delayNs + afterNs);
    }
  }

  private long baseDelayNs(SimRadio from, Station to, Packet packet, long datagram) {
    if (!seeded) {
      Rng rng = new Rng(from.copySeed(to, datagram));
      Transmission copy =
          new Transmission(from.id(), to.id, clock.nowNs(), datagram, packet.length(), rng);
      return choice.delayNsOrLost(copy, latency, loss);
    }
    if (loss.isCertain() && latency.isConstant()) {
      return loss.probability() > 0 ? LinkChoice.LOST : ((Latency.Constant) latency).ns();
    }
    // As LinkChoice.seeded() does, without a Transmission.
    Rng rng = new Rng(from.copySeed(to, datagram));
    return loss.strikes(rng) ? LinkChoice.LOST : latency.drawNs(rng);
  }

  private void deliver(SimRadio from, Station to, Packet packet, long delayNs) {
    SimRadio radio = to.radio;
    if (radio == null) {
      dropped(from.id(), to.id, "no-such-robot");
      return;
    }
    to.inbox.schedule(clock.nowNs() + delayNs, pool.delivery(from.id(), radio, packet));
  }

  private Station station(RobotId id) {
    Station station = stations.find(id);
    return station == null ? newStation(id) : station;
  }

  private Station newStation(RobotId id) {
    return new Station(id, root.fork(id.name() + "/radio").nextLong());
  }

  /** So that one rule installed twice can be taken out once. */
  private static final class Installed {
    private final LinkRule rule;

    Installed(LinkRule rule) {
      this.rule = rule;
    }
  }

  /**
   * What the network knows of a robot; of this, its key and how many datagrams its earlier incarnations
   * sent outlive a restart.
   */
  static final class Station {
    private final RobotId id;
    private final long key;
    private long datagrams;
    private @Nullable SimRadio radio;
    private Inbox inbox = NOWHERE;

    Station(RobotId id, long key) {
      this.id = id;
      this.key = key;
    }

    RobotId id() {
      return id;
    }

    long key() {
      return key;
    }

    long datagrams() {
      return datagrams;
    }
  }
}
