package org.starl.apps.hello;

import org.starl.apps.AppFactory;
import org.starl.apps.FactoryDemo;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.hello.robot.HelloFactory;
import org.starl.apps.hello.view.HelloLayer;
import org.starl.geometry.Obstacles;
import org.starl.primitives.motion.MotionSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/** {@code starl run hello}. */
public final class HelloDemo implements FactoryDemo {

  private static final HelloFactory FACTORY = new HelloFactory();

  @Override
  public AppFactory factory() {
    return FACTORY;
  }

  @Override
  public String summary() {
    return "each robot drives one metre: the smallest app";
  }

  @Override
  public Envelope envelope() {
    return Envelope.SPATIAL;
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    HelloStory story = new HelloStory();
    Simulation.Builder simulation =
        Simulation.builder()
            .settings(settings)
            .robots(request.robots().orElse(settings.robots()), FACTORY.program(request).app())
            .monitor(() -> new MotionSpec(settings.motionParameters(0)))
            .observer(story);
    return new Plan(simulation, story, new HelloLayer(), Obstacles.NONE);
  }
}
