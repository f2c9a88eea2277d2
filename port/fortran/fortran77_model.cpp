// A model by calls: section 5 of contact2d.h for FORTRAN.
#include "fortran77.hpp"

#include <string.h>

using namespace c2d::fortran;

void c2prob_(Work work, In iplane, In iout, In itmax, Text title, In ltitle, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_problem problem = C2D_INIT(c2d_problem);
    problem.plane = integer_at(iplane);
    problem.analysis = integer_at(iout);
    problem.iteration_limit = integer_at(itmax);
    const int32_t room = static_cast<int32_t>(sizeof problem.title), length = integer_at(ltitle);
    get_text(title, length < room ? length : room - 1, problem.title, room);
    call.status = c2d_set_problem(call.solver, &problem);
  }
  call.leave(ierr);
}

void c2body_(Work work, In ibody, In nbn, In nel, In nren, In nopen, In young, In poiss, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_body body = C2D_INIT(c2d_body);
    body.element_nodes = integer_at(nbn);
    body.elements = integer_at(nel);
    body.regions = integer_at(nren);
    body.open_regions = integer_at(nopen);
    body.youngs_modulus = real_at(young);
    body.poisson_ratio = real_at(poiss);
    call.status = c2d_set_body(call.solver, integer_at(ibody), &body);
  }
  call.leave(ierr);
}

void c2regn_(Work work, In ibody, In ifirst, In ilast, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_add_region(call.solver, integer_at(ibody), integer_at(ifirst), integer_at(ilast));
  call.leave(ierr);
}

// The last node is set first: if there are too many, the call fails before anything has changed.
void c2node_(Work work, In ibody, In ifirst, In n, In xy, In ldxy, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const int32_t body = integer_at(ibody), first = integer_at(ifirst), count = integer_at(n);
    const int64_t stride = integer_at(ldxy);
    if (is_aligned(xy) || count < 1 || stride < 2) { // the latter are refused
      call.status = c2d_set_nodes(call.solver, body, first, count, static_cast<const double*>(xy), stride);
    } else {
      for (int32_t i = count - 1; i >= 0 && call.status == C2D_OK; --i) {
        const Reals point(static_cast<const char*>(xy) + i * stride * 8, 2);
        call.status =
            first > INT32_MAX - i ? C2D_ERR_ARGUMENT : c2d_set_nodes(call.solver, body, first + i, 1, point.data(), 2);
      }
    }
  }
  call.leave(ierr);
}

void c2nlin_(Work work, In ibody, In ifirst, In ilast, In origin, In from, In to, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const Reals base(origin, 2), start(from, 2), end(to, 2);
    call.status = c2d_set_line_nodes(call.solver, integer_at(ibody), integer_at(ifirst), integer_at(ilast), base.data(),
                                     start.data(), end.data());
  }
  call.leave(ierr);
}

void c2narc_(Work work, In ibody, In ifirst, In ilast, In centre, In radius, In angle1, In angle2, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const Reals middle(centre, 2);
    call.status = c2d_set_arc_nodes(call.solver, integer_at(ibody), integer_at(ifirst), integer_at(ilast), middle.data(),
                                    real_at(radius), real_at(angle1), real_at(angle2));
  }
  call.leave(ierr);
}

void c2cond_(Work work, In ibody, In ielem, In ilocal, In icase, In icodes, In values, Out ierr) {
  Call call(work);
  if (call.ready()) {
    int32_t codes[4];
    memcpy(codes, icodes, sizeof codes);
    const Reals known(values, 4);
    call.status = c2d_set_condition(call.solver, integer_at(ibody), integer_at(ielem), integer_at(ilocal), integer_at(icase),
                                    codes, known.data());
  }
  call.leave(ierr);
}

void c2case_(Work work, In ibody, In ielem, In ilocal, In icase, In values, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const Reals known(values, 4);
    call.status =
        c2d_set_values(call.solver, integer_at(ibody), integer_at(ielem), integer_at(ilocal), integer_at(icase), known.data());
  }
  call.leave(ierr);
}

void c2load_(Work work, In ibody, In icase, In x, In y, In fx, In fy, Out ierr) {
  Call call(work);
  if (call.ready())
    call.status =
        c2d_add_point_load(call.solver, integer_at(ibody), integer_at(icase), real_at(x), real_at(y), real_at(fx), real_at(fy));
  call.leave(ierr);
}

void c2rigd_(Work work, In ibody, In icase, In motion, In axis, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const Reals moved(motion, 3), centre(axis, 2);
    call.status = c2d_set_rigid(call.solver, integer_at(ibody), integer_at(icase), moved.data(), centre.data());
  }
  call.leave(ierr);
}

void c2rgld_(Work work, In ibody, In icase, In ifree, In force, In point, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const Reals load(force, 3), centre(point, 2);
    const int32_t is_free[] = {integer_at(ifree, 0), integer_at(ifree, 1), integer_at(ifree, 2)};
    call.status = c2d_set_rigid_load(call.solver, integer_at(ibody), integer_at(icase), is_free, load.data(), centre.data());
  }
  call.leave(ierr);
}

void c2plat_(Work work, In ibody, In ielem, In ifree, In point, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const Reals centre(point, 2);
    const int32_t is_free[] = {integer_at(ifree, 0), integer_at(ifree, 1), integer_at(ifree, 2)};
    call.status = c2d_add_platen(call.solver, integer_at(ibody), integer_at(ielem, 0), integer_at(ielem, 1),
                                 integer_at(ielem, 2), is_free, centre.data());
  }
  call.leave(ierr);
}

void c2intf_(Work work, In icase, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_set_interference(call.solver, integer_at(icase));
  call.leave(ierr);
}

void c2bfor_(Work work, In ibody, In icase, In force, In rhom2, In axis, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const Reals weight(force, 2), centre(axis, 2);
    call.status =
        c2d_set_body_force(call.solver, integer_at(ibody), integer_at(icase), weight.data(), real_at(rhom2), centre.data());
  }
  call.leave(ierr);
}

// ISIDE1(6), ISIDE2(6): body, first and last element, number of elements, first and last node.
void c2zone_(Work work, In ikind, In npairs, In iside1, In iside2, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_zone zone = C2D_INIT(c2d_zone);
    zone.kind = integer_at(ikind);
    zone.pairs = integer_at(npairs);
    memcpy(&zone.side1, iside1, sizeof zone.side1);
    memcpy(&zone.side2, iside2, sizeof zone.side2);
    call.status = c2d_add_zone(call.solver, &zone);
  }
  call.leave(ierr);
}

void c2tie_(Work work, In izone, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_tie_zone(call.solver, integer_at(izone));
  call.leave(ierr);
}

void c2mu_(Work work, In fmu, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_add_friction(call.solver, real_at(fmu));
  call.leave(ierr);
}

void c2muz_(Work work, In izone, In i, In fmu, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_set_zone_friction(call.solver, integer_at(izone), integer_at(i), real_at(fmu));
  call.leave(ierr);
}

void c2symm_(Work work, In iaxis, In value, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_set_symmetry(call.solver, integer_at(iaxis), real_at(value));
  call.leave(ierr);
}

void c2path_(Work work, In ninc, In factor, In ncases, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const int32_t cases = integer_at(ncases);
    const Reals load(factor, cases);
    call.status = !load.ok() ? C2D_ERR_LIMIT : c2d_add_path(call.solver, integer_at(ninc), load.data(), cases);
  }
  call.leave(ierr);
}

void c2clrp_(Work work, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_clear_paths(call.solver);
  call.leave(ierr);
}

void c2acrv_(Work work, In ikind, In ibody, In ielem, In circle, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_curve curve = C2D_INIT(c2d_curve);
    curve.kind = integer_at(ikind);
    curve.body = integer_at(ibody);
    curve.first_element = integer_at(ielem, 0);
    curve.last_element = integer_at(ielem, 1);
    for (int32_t j = 0; j < 2; ++j) curve.centre[j] = real_at(circle, j);
    curve.radius = real_at(circle, 2);
    call.status = c2d_add_curve(call.solver, &curve);
  }
  call.leave(ierr);
}

void c2apts_(Work work, In ikind, In ibody, In icount, In from, In to, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_points points = C2D_INIT(c2d_points);
    points.kind = integer_at(ikind);
    points.body = integer_at(ibody);
    for (int32_t j = 0; j < 2; ++j) {
      points.count[j] = integer_at(icount, j);
      points.from[j] = real_at(from, j);
      points.to[j] = real_at(to, j);
    }
    call.status = c2d_add_points(call.solver, &points);
  }
  call.leave(ierr);
}

void c2unit_(Work work, Text length, In llen, Text force, In lforce, Out ierr) {
  Call call(work);
  if (call.ready()) {
    char names[2][24]; // the library refuses what is longer than it keeps
    const int32_t room = static_cast<int32_t>(sizeof names[0]);
    get_text(length, integer_at(llen) < room ? integer_at(llen) : room - 1, names[0], room);
    get_text(force, integer_at(lforce) < room ? integer_at(lforce) : room - 1, names[1], room);
    call.status = c2d_set_units(call.solver, names[0], names[1]);
  }
  call.leave(ierr);
}

void c2name_(Work work, In ikind, In i, Text name, In lname, Out ierr) {
  Call call(work);
  if (call.ready()) {
    char text[40]; // the library refuses what is longer than it keeps
    const int32_t room = static_cast<int32_t>(sizeof text), length = integer_at(lname);
    get_text(name, length < room ? length : room - 1, text, room);
    call.status = c2d_set_name(call.solver, integer_at(ikind), integer_at(i), text);
  }
  call.leave(ierr);
}

void c2line_(Work work, In iline, In icol, In icol2, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_set_line(call.solver, integer_at(iline), integer_at(icol), integer_at(icol2));
  call.leave(ierr);
}

void c2done_(Work work, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_complete(call.solver);
  call.leave(ierr);
}
