package org.starl.bench;

import java.util.List;
import java.util.Optional;

/** All workloads. */
public final class Workloads {

  private static final List<Workload> ALL = List.of(new KernelWorkload(), new PatrolWorkload());

  private Workloads() {}

  public static List<Workload> all() {
    return ALL;
  }

  public static Optional<Workload> byName(String name) {
    return ALL.stream().filter(workload -> workload.name().equals(name)).findFirst();
  }
}
