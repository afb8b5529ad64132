package org.starl.primitives.paths;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.starl.GlobalVarHolder;
import org.starl.Persistent;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Timer;
import org.starl.shape.Shapes;

/** Connects the {@link TubeClaims} of a robot to its gvh. Strand only. */
final class TubePort implements TubeClaims.Port {

  final TubeClaims claims;

  private final GlobalVarHolder gvh;
  private final String name;
  private final Map<String, Persistent<Optional<TubeVoter.Note>>> stable = new TreeMap<>();
  private final GvhCell<TubeList> held;
  private final Timer timer;
  private final Endpoint<TubeMessage> endpoint;

  TubePort(
      GlobalVarHolder gvh,
      Channel<TubeMessage> channel,
      Participants participants,
      TubeSettings settings,
      int radiusMm,
      TubeClaims.Listener listener) {
    this.gvh = gvh;
    name = channel.name();
    claims =
        new TubeClaims(
            gvh.id.name(), gvh.id.boot(), participants, settings, radiusMm, this, listener);
    held = gvh.variable(channel.instance(), TubeFact.HELD, new TubeList(claims.held()));
    timer = gvh.plat.timers.timer(claims::expired);
    endpoint = gvh.comms.open(channel, claims::received);
    gvh.gps.onFix(claims::place);
    claims.begin();
  }

  void close() {
    claims.close();
    timer.cancel();
    endpoint.close();
  }

  @Override
  public long nowNs() {
    return gvh.plat.clock.nowNs();
  }

  @Override
  public Point at() {
    return gvh.gps.pose().at();
  }

  @Override
  public Optional<TubeVoter.Note> stored(String key) {
    return variable(key).get();
  }

  @Override
  public void store(String key, TubeVoter.Note note, Runnable whenFlushed) {
    variable(key).set(Optional.of(note), whenFlushed);
  }

  private Persistent<Optional<TubeVoter.Note>> variable(String key) {
    return stable.computeIfAbsent(
        key,
        any ->
            gvh.plat.persistent(
                name + key, Shapes.optional(TubeVoter.Note.SHAPE), Optional.empty()));
  }

  @Override
  public void send(RobotId to, TubeMessage message) {
    endpoint.send(to, message);
  }

  @Override
  public void holds(TubeList tubes) {
    held.set(tubes);
  }

  @Override
  public void wakeAt(long timeNs) {
    timer.set(timeNs);
  }
}
