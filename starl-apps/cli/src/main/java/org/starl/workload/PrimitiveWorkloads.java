package org.starl.workload;

import java.util.List;
import org.starl.apps.Demo;

/** The primitives that have a workload. */
public final class PrimitiveWorkloads {

  /** In the order of their names. */
  public static final List<Demo> ALL =
      List.of(
          new AgreementWorkload(),
          new BarrierWorkload(),
          new ElectionWorkload(),
          new GeocastWorkload(),
          new MotionWorkload(),
          new MutexWorkload(),
          new PathsWorkload(),
          new RegistrationWorkload());

  private PrimitiveWorkloads() {}
}
