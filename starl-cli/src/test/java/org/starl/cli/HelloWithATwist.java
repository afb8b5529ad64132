package org.starl.cli;

import java.util.List;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.hello.HelloDemo;
import org.starl.sim.SimSettings;
import org.starl.sim.fault.Envelope;

/** Hello, or another demo, under another name, with a plan that a test changes. */
public abstract class HelloWithATwist implements Demo {
  private final Demo hello;
  private final String name;
  private final String summary;

  public HelloWithATwist(String name, String summary) {
    this(new HelloDemo(), name, summary);
  }

  public HelloWithATwist(Demo hello, String name, String summary) {
    this.hello = hello;
    this.name = name;
    this.summary = summary;
  }

  /** The plan to run instead of hello's own. */
  protected abstract Plan twist(Plan plan, Request request);

  @Override
  public String name() {
    return name;
  }

  @Override
  public String summary() {
    return summary;
  }

  @Override
  public List<Parameter> parameters() {
    return hello.parameters();
  }

  @Override
  public Envelope envelope() {
    return hello.envelope();
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    return hello.defaultSettings(request);
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    return twist(hello.plan(request, settings), request);
  }
}
