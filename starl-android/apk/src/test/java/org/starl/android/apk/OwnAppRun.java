package org.starl.android.apk;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.function.Function;
import org.starl.apps.AppFactory;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.DeploymentReader;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.sim.TraceRecorder;

/**
 * Reads a deployment, finds its app as a phone does, and simulates its robots with the app's monitors;
 * returns the trace.
 */
public final class OwnAppRun implements Function<String, byte[]> {

  @Override
  public byte[] apply(String text) {
    Deployment deployment = DeploymentReader.read("deployment.yaml", text);
    AppFactory app = AppFactory.installed().get(deployment.app());
    SortedMap<String, String> parameters = app.defaults();
    parameters.putAll(deployment.parameters());
    int robots = deployment.robots().size();
    RobotProgram program =
        app.program(new Request(deployment.seed(), OptionalInt.of(robots), parameters));
    Simulation.Builder simulation =
        Simulation.builder()
            .name(app.name())
            .seed(deployment.seed())
            .robots(robots, program.app())
            .obstacles(program.knownObstacles());
    program.monitors().forEach(simulation::monitor);
    ByteArrayOutputStream trace = new ByteArrayOutputStream();
    try (TraceRecorder recorder = new TraceRecorder(trace)) {
      SimResult result = simulation.observer(recorder).build().run();
      if (!result.spec().holds() || result.spec().lemmas().isEmpty()) {
        throw new AssertionError(result.spec().violations());
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return trace.toByteArray();
  }
}
