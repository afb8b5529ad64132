package org.starl.workload;

import java.util.List;
import org.starl.apps.Demo;
import org.starl.sim.fault.Envelope;

/** The primitives that have a workload. */
public final class PrimitiveWorkloads {

  /** By name. */
  public static final List<Demo> ALL =
      List.of(
          new PrimitiveWorkload(
              "agreement",
              "robots agree on one value after another, each proposing its own",
              Envelope.LOGICAL,
              64,
              PrimitiveWorkload.parameters(10, "20s"),
              AgreementClient::setUp),
          new PrimitiveWorkload(
              "barrier",
              "registered robots meet at a barrier again and again",
              Envelope.LOGICAL,
              32,
              PrimitiveWorkload.parameters(10, "20s"),
              BarrierClient::setUp),
          new PrimitiveWorkload(
              "election",
              "robots elect one leader after another, and follow all of them",
              Envelope.LOGICAL,
              64,
              PrimitiveWorkload.parameters(5, "20s", ElectionClient.STRATEGY),
              ElectionClient::setUp),
          new PrimitiveWorkload(
              "geocast",
              "moving robots send to areas of all shapes, and to all robots",
              Envelope.SPATIAL,
              64,
              PrimitiveWorkload.parameters(12, "20s"),
              GeocastClient::setUp),
          new PrimitiveWorkload(
              "motion",
              "robots drive to random places, outside regions that may be in the way",
              Envelope.SPATIAL,
              64,
              PrimitiveWorkload.parameters(8, "20s"),
              MotionClient::setUp),
          new PrimitiveWorkload(
              "mutex",
              "robots enter sets of sections, each again and again, over a registration",
              Envelope.LOGICAL,
              32,
              PrimitiveWorkload.parameters(10, "20s", MutexClient.SECTIONS, MutexClient.MEMBERS),
              MutexClient::setUp),
          new PrimitiveWorkload(
              "paths",
              "robots drive all over a floor with walls, in tubes that never meet",
              Envelope.SPATIAL,
              16,
              PrimitiveWorkload.parameters(6, "60s", PathsClient.PLANNER),
              PathsClient::setUp),
          new PrimitiveWorkload(
              "registration",
              "robots register, stay a while, and unregister, again and again",
              Envelope.LOGICAL,
              32,
              PrimitiveWorkload.parameters(10, "20s"),
              RegistrationClient::setUp));

  private PrimitiveWorkloads() {}
}
