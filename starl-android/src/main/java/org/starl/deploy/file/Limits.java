package org.starl.deploy.file;

/**
 * What keeps a robot's wheels in check, below its program.
 *
 * @param speedMmPerS no wheel turns faster
 * @param watchdogMs a program that has said nothing for so long has its wheels stopped
 * @param positionMs so long after the last fix the wheels are stopped
 */
public record Limits(double speedMmPerS, int watchdogMs, int positionMs) {}
