plugins {
    `java-library`
    id("maven-publish")
}

description = "Platform and physical layers, simulated; no window"

dependencies {
    api(project(":starl-core"))
    api(project(":starl-core-input"))
    api(libs.jspecify)
    // For the tests of users: a program that only simulates does not need it.
    compileOnly(libs.junit.jupiter.api)
    testImplementation(libs.junit.platform.testkit)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}
