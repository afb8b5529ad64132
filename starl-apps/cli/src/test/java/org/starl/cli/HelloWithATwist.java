package org.starl.cli;

import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.hello.HelloDemo;
import org.starl.sim.SimSettings;
import org.starl.sim.fault.Envelope;

/** Hello under another name, with a plan that a test changes. */
abstract class HelloWithATwist implements Demo {
  private final Demo hello = new HelloDemo();
  private final String name;
  private final String summary;

  HelloWithATwist(String name, String summary) {
    this.name = name;
    this.summary = summary;
  }

  /** The plan to run instead of hello's own. */
  abstract Plan twist(Plan plan, Request request);

  @Override
  public String name() {
    return name;
  }

  @Override
  public String summary() {
    return summary;
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
