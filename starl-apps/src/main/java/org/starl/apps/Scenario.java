package org.starl.apps;

/**
 * A scenario of an app: {@code --set scenario=NAME}.
 *
 * @param what one line
 */
public record Scenario(String name, String what) {}
